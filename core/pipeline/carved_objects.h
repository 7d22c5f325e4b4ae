// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/write_model.h"
#include "pipeline/engrave.h"

namespace qrelief {

/// Returns the objects of a carved model's file, one for each part of the model. The carved part's object has the inlay
/// as its second body, in its own colour, if there is an inlay and `withInlay` is set.
/// @param partNames  names of the model's parts; empty: one part only
/// @param painted    triangles of the carved mesh in the second colour, ascending
std::vector<ModelObject> carvedObjects(const EngraveResult& result, std::span<const std::string> partNames,
                                       bool withInlay, std::span<const std::uint32_t> painted = {});

/// Returns the body of the second colour.
ModelBody codeBody(const Mesh& inlay);

/// Returns the objects as one of several copies on a plate (batch/plate_layout.h). Every object's name then begins with
/// the copy's id, and its description is the code's text.
std::vector<ModelObject> copyOnPlate(std::vector<ModelObject> objects, const std::string& id, const std::string& text,
                                     Vec3 offsetMm);

}  // namespace qrelief
