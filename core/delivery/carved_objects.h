// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "carving/mark.h"
#include "io/three_mf/rewrite_3mf.h"
#include "io/write_model.h"

namespace qrelief {

struct EngraveRequest;
struct EngraveResult;

/// Returns true if the format can hold everything that the request makes: one body, a body and its inlay, or painted
/// facets.
bool holdsColoursOf(const EngraveRequest& request, ModelFormat format);

/// Returns the marks in colour that files of that format can hold.
std::vector<Mark> marksInColour(ModelFormat format);

/// Returns the objects of a carved model's file, one for each part of the model. The inlay, in its own colour, follows
/// the carved body if there is an inlay and `withInlay` is set. Painted facets have the inlay's colour.
/// @param partNames  names of the model's parts; empty: one part only
/// @param apart      keep the bodies that the model's file names apart (3MF, OBJ); otherwise an object is one body
std::vector<ModelObject> carvedObjects(const EngraveResult& result, std::span<const std::string> partNames,
                                       bool withInlay, bool apart);

/// Returns the body of the second colour.
ModelBody codeBody(const Mesh& inlay);

/// Returns the materials of the model and of the code.
std::array<Material, 2> filamentMaterials();

}  // namespace qrelief
