// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <cmath>

#include "math/vec.h"

namespace qrelief {

/// Walks along a ray from cell to cell of a grid of unit squares [Amanatides, Woo 1987].
class GridMarch {
 public:
  /// @param cell   first cell: column, row
  /// @param place  start within that cell, 0 … 1 along each axis
  /// @param along  unit direction, parallel to no axis
  GridMarch(glm::ivec2 cell, Vec2 place, Vec2 along) : cell_(cell) {
    assert(along.x != 0 && along.y != 0);
    for (int axis = 0; axis < 2; ++axis) {
      perCell_[axis] = 1 / std::abs(along[axis]);
      forward_[axis] = along[axis] > 0 ? 1 : -1;
      next_[axis] = (along[axis] > 0 ? 1 - place[axis] : place[axis]) / std::abs(along[axis]);
    }
  }

  /// Enters the next cell. At a corner of the grid, crosses the row's border first.
  /// @return distance from the start to the border just crossed
  double step() {
    const int axis = next_.x < next_.y ? 0 : 1;
    const double distance = next_[axis];
    next_[axis] += perCell_[axis];
    cell_[axis] += forward_[axis];
    return distance;
  }

  glm::ivec2 cell() const { return cell_; }

 private:
  glm::ivec2 cell_;
  glm::ivec2 forward_;
  Vec2 next_;     // distances from the start at which the ray leaves its column and its row
  Vec2 perCell_;  // distances between two such borders
};

}  // namespace qrelief
