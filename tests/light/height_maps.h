// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "light/height_map.h"

namespace qrelief {

/// Returns a height map of the QR plane itself.
inline HeightMap planeMap(int size, double patchMm, double eyeDistance) {
  const auto count = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  const std::vector<float> zeros(count, 0.0f);
  return {size, patchMm, eyeDistance, zeros, zeros, zeros};
}

}  // namespace qrelief
