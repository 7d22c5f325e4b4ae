// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "projection/plane_shapes.h"

namespace qrelief {

/// Signed distances from an outline in the plane of a printed layer, mm, negative inside, at the nodes of a grid.
struct LayerGrid {
  Vec2 origin{0};  ///< of node (0, 0), mm
  double stepMm = 0.1;
  int columns = 0, rows = 0;      ///< number of nodes; none: the layer is not computed
  std::vector<float> distanceMm;  ///< row-major

  bool empty() const { return distanceMm.empty(); }
  Vec2 node(int column, int row) const { return origin + stepMm * Vec2(column, row); }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }

  /// Interpolates between the nodes, bilinearly. @param at  within the grid
  double at(Vec2 at) const;
};

/// Sets each node to its signed distance from the nearest segment, minus `lessMm`. Distances are exact up to `reachMm`;
/// farther nodes get `reachMm` or more.
/// Cost: O(nodes + segments · nodes within `reachMm` of one).
/// @param inside  a value for each node; the distance is negative where it is below `lessThan`
void setDistances(LayerGrid& grid, std::span<const Segment2> segments, double reachMm, std::span<const float> inside,
                  double lessThan, double lessMm);

/// Finds the contour of a distance, in pieces from one edge of a grid cell to another, unordered [marching squares;
/// Maple 2003]. Cost: O(nodes).
std::vector<Segment2> contourOf(const LayerGrid& grid, double valueMm);

}  // namespace qrelief
