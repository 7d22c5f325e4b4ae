// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "math/box.h"

namespace qrelief {

/// Where copies of one model stand side by side on a plate: rows of about as many as there are rows, apart by `gapMm`,
/// the lowest corner of the first at the origin.
/// @param box   of the model, mm
/// @returns what each copy is to be moved by, mm, to 0.01 mm upwards
std::vector<Vec3> plateOffsets(const Box3& box, std::size_t copies, double gapMm = 5);

/// "plate-007.3mf", in as many digits as the last of them has, at least three. @param plate  from 0
std::string plateName(std::size_t plate, std::size_t plates);

}  // namespace qrelief
