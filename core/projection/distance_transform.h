// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace qrelief {

/// Computes the squared distance between each texel's middle and the middle of the nearest blocked texel, in texels:
/// exact integers [Felzenszwalb, Huttenlocher 2012: lower envelope of parabolas, a row at a time].
///
/// Cost: O(texels²).
/// @param blocked  texels² values, row-major; not 0 = blocked; at least one texel is blocked
std::vector<std::int32_t> squaredDistances(std::span<const std::uint8_t> blocked, int texels);

}  // namespace qrelief
