// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace qrelief {

/// Squared distance of each texel's middle from that of the nearest blocked texel, in texels: exact integers
/// [Felzenszwalb, Huttenlocher 2012: lower envelope of parabolas, a row at a time].
///
/// Cost: O(texels²).
/// @param blocked  texels², row-major; not 0 = blocked; at least one is
std::vector<std::int32_t> squaredDistances(std::span<const std::uint8_t> blocked, int texels);

}  // namespace qrelief
