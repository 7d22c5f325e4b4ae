// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/write_model.h"
#include "math/box.h"

namespace qrelief {

/// Lays out copies of one model side by side on a plate: about as many rows as columns, `gapMm` apart, with the lowest
/// corner of the first at the origin.
/// @param box   bounding box of the model, mm
/// @returns the offset of each copy, mm, rounded up to 0.01 mm
std::vector<Vec3> plateOffsets(const Box3& box, std::size_t copies, double gapMm = 5);

/// Names the objects of one of several copies on a plate: every object's name then begins with the copy's id, and its
/// description is the code's text.
std::vector<ModelObject> namedCopy(std::vector<ModelObject> objects, const std::string& id, const std::string& text);

/// Puts copies of a model side by side (plateOffsets()), turned as they are printed.
/// @param copies  the objects of each; empty: its place stays free
std::vector<ModelObject> onPlate(std::vector<std::vector<ModelObject>> copies);

/// Returns a name such as "plate-007.3mf", with as many digits as the last plate needs, at least three.
/// @param plate  from 0
std::string plateName(std::size_t plate, std::size_t plates);

}  // namespace qrelief
