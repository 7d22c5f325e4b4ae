// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/write_model.h"
#include "pipeline/engrave.h"

namespace qrelief {

/// A carved model as a file holds it: an object for each part of the model, the carved one with the inlay as its second
/// body, in a colour of its own, if there is an inlay and it is wanted.
/// @param partNames  of the model's parts; empty: it has one only
std::vector<ModelObject> carvedObjects(const EngraveResult& result, std::span<const std::string> partNames,
                                       bool withInlay);

/// The same as one of several copies on a plate (batch/plate_layout.h): every object's name begins with the copy's id,
/// and its description is the code's text.
std::vector<ModelObject> copyOnPlate(std::vector<ModelObject> objects, const std::string& id, const std::string& text,
                                     Vec3 offsetMm);

}  // namespace qrelief
