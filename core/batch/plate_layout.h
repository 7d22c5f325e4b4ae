// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "math/box.h"

namespace qrelief {

/// Lays out copies of one model side by side on a plate: about as many rows as columns, `gapMm` apart, with the lowest
/// corner of the first at the origin.
/// @param box   bounding box of the model, mm
/// @returns the offset of each copy, mm, rounded up to 0.01 mm
std::vector<Vec3> plateOffsets(const Box3& box, std::size_t copies, double gapMm = 5);

/// Returns a name such as "plate-007.3mf", with as many digits as the last plate needs, at least three.
/// @param plate  from 0
std::string plateName(std::size_t plate, std::size_t plates);

}  // namespace qrelief
