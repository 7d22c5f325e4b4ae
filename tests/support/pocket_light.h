// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "base/grid.h"
#include "depth/depth_field.h"
#include "depth/pocket_sky.h"
#include "qr/symbol.h"

namespace qrelief {

/// Returns the luminances of a symbol's submodules and its quiet zone on a plane: PocketSky with interreflection, 1
/// where nothing is carved.
/// @param factor  (row, column) → factor of a carved submodule's luminance
inline Grid<double> pocketLuminances(
    const PocketSky& sky, const DepthField& field,
    const std::function<double(int, int)>& factor = [](int, int) { return 1.0; }) {
  constexpr double kAlbedo = 0.7;
  const int edge = field.size + 2 * kQuietZoneSubmodules;
  Grid<double> all(edge, edge, 1);
  std::vector<double> depths;
  for (const std::uint32_t i : sky.carved()) depths.push_back(field.depthMm[i]);
  const PocketSky::Depths onPlane(sky, depths);
  for (std::size_t k = 0; k < depths.size(); ++k) {
    const int row = static_cast<int>(sky.carved()[k]) / field.size;
    const int column = static_cast<int>(sky.carved()[k]) % field.size;
    const double seen = onPlane.fraction(k, depths[k]);
    all.at(row + kQuietZoneSubmodules, column + kQuietZoneSubmodules) =
        factor(row, column) * seen / (1 - kAlbedo * (1 - seen));
  }
  return all;
}

}  // namespace qrelief
