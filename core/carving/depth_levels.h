// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "depth/depth_field.h"
#include "math/tolerance.h"

namespace qrelief {

/// A depth field in whole quanta, so that depths compare as integers. Level 0 = not carved.
struct DepthLevels {
  int size = 0;  ///< submodules along an edge
  double symbolMm = 0;
  std::vector<int> level;  ///< row-major like DepthField::depthMm

  /// Returns the level of a submodule; 0 beyond the symbol's edge.
  int at(int row, int column) const {
    if (row < 0 || column < 0 || row >= size || column >= size) return 0;
    return level[row * size + column];
  }
  double submoduleMm() const { return symbolMm / size; }
  Vec2 corner(int row, int column) const {
    return {-symbolMm / 2 + column * submoduleMm(), symbolMm / 2 - row * submoduleMm()};
  }
};

inline double depthOfLevel(int level) { return level * kDepthQuantumMm; }

}  // namespace qrelief
