// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/tolerance.h"
#include "math/vec.h"

namespace qrelief {

/// Carving depth of every submodule, along the rays of the central projection.
///
/// Row-major from the symbol's top left; submodule (row, column) covers, in plane coordinates (mm, v upwards),
///     u ∈ [-s/2 + column·h, …+h],   v ∈ [s/2 - (row+1)·h, …+h],   h = symbolMm / size
struct DepthField {
  int size = 0;                 ///< submodules along an edge, 5·modules
  double symbolMm = 0;          ///< edge s of the symbol without quiet zone, on the QR plane
  std::vector<double> depthMm;  ///< ≥ 0, multiples of kDepthQuantumMm; 0 = not carved

  double depth(int row, int column) const { return depthMm[row * size + column]; }
  double submoduleMm() const { return symbolMm / size; }

  /// Returns the plane point of grid corner (row, column), 0 … size: row 0 is the symbol's top edge.
  Vec2 corner(int row, int column) const {
    return {-symbolMm / 2 + column * submoduleMm(), symbolMm / 2 - row * submoduleMm()};
  }
};

/// Rounds a depth up to the grid of the files (kDepthQuantumMm). If the result would exceed the limit, returns the
/// limit rounded down.
inline double quantisedDepth(double depthMm, double limitMm) {
  const double up = std::ceil(depthMm / kDepthQuantumMm - 1e-9) * kDepthQuantumMm;
  if (up <= limitMm) return up;
  return std::max(0.0, std::floor(limitMm / kDepthQuantumMm + 1e-9) * kDepthQuantumMm);
}

}  // namespace qrelief
