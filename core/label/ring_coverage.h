// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "label/text_outline.h"

namespace qrelief {

/// Returns how much of each pixel of a square picture rings cover, 0 … 255, row 0 at the top. The picture's centre is
/// the origin. Exact along the rows [scan conversion by the even-odd rule]; four lines sample the height of a pixel.
///
/// Cost: O(pixels² + corners · pixels that an edge spans).
/// @param rings   of which none cross; parts outside the picture are cut off
/// @param pixels  along the edge, > 0
/// @param edge    of the picture, in the rings' unit, > 0
std::vector<std::uint8_t> ringCoverage(std::span<const Ring> rings, int pixels, double edge);

}  // namespace qrelief
