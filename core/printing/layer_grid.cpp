// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/layer_grid.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "printing/distance_rows.h"

namespace qrelief {
namespace {

constexpr int kBlock = 8;  // cells tested one by one after nextCrossed()

}  // namespace

double LayerGrid::at(Vec2 at) const {
  const Vec2 place = (at - origin) / stepMm;
  const int column = std::clamp(static_cast<int>(place.x), 0, columns - 2);
  const int row = std::clamp(static_cast<int>(place.y), 0, rows - 2);
  const double u = place.x - column, v = place.y - row;
  const float* corner = &distanceMm[index(column, row)];
  const float* above = corner + columns;
  return (1 - v) * ((1 - u) * static_cast<double>(corner[0]) + u * static_cast<double>(corner[1])) +
         v * ((1 - u) * static_cast<double>(above[0]) + u * static_cast<double>(above[1]));
}

void setDistances(LayerGrid& grid, std::span<const Segment2> segments, double reachMm, std::span<const float> inside,
                  double lessThan, double lessMm) {
  const std::size_t nodes = grid.index(0, grid.rows);
  assert(inside.size() == nodes);
  grid.distanceMm.assign(nodes, static_cast<float>(reachMm * reachMm));
  for (const Segment2& segment : segments) {
    const Vec2 low = (glm::min(segment[0], segment[1]) - grid.origin - reachMm) / grid.stepMm;
    const Vec2 high = (glm::max(segment[0], segment[1]) - grid.origin + reachMm) / grid.stepMm;
    const int firstColumn = std::max(0, static_cast<int>(std::ceil(low.x)));
    const int lastColumn = std::min(grid.columns - 1, static_cast<int>(std::floor(high.x)));
    const int firstRow = std::max(0, static_cast<int>(std::ceil(low.y)));
    const int lastRow = std::min(grid.rows - 1, static_cast<int>(std::floor(high.y)));
    if (lastRow < firstRow || lastColumn < firstColumn) continue;
    const Vec2 from = segment[0] - grid.node(firstColumn, firstRow), along = segment[1] - segment[0];
    lowerRows({&grid.distanceMm[grid.index(firstColumn, firstRow)], static_cast<std::size_t>(grid.columns),
               lastColumn - firstColumn + 1, lastRow - firstRow + 1, static_cast<float>(grid.stepMm),
               static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(along.x),
               static_cast<float>(along.y)});
  }
  signedDistances(grid.distanceMm.data(), inside.data(), static_cast<float>(lessThan), static_cast<float>(lessMm),
                  nodes);
}

std::vector<Segment2> contourOf(const LayerGrid& grid, double valueMm) {
  std::vector<Segment2> contour;
  const auto value = static_cast<float>(valueMm);
  for (int row = 0; row + 1 < grid.rows; ++row) {
    const float* const lower = &grid.distanceMm[grid.index(0, row)];
    const float* const upper = lower + grid.columns;
    const int cells = grid.columns - 1;
    for (int column = 0, blockEnd = 0; column < cells; ++column) {
      if (column == blockEnd) {
        column = nextCrossed(lower, upper, value, column, cells);
        blockEnd = std::min(column + kBlock, cells);
        if (column == cells) break;
      }
      const int below =
          (lower[column] < value) + (upper[column] < value) + (lower[column + 1] < value) + (upper[column + 1] < value);
      if (below == 0 || below == 4) continue;
      // Corners anticlockwise from the lower left; a crossing on each side whose ends differ.
      constexpr std::array<std::array<int, 2>, 4> kCorners = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
      std::array<double, 4> over{};
      for (std::size_t k = 0; k < 4; ++k)
        over[k] =
            static_cast<double>(grid.distanceMm[grid.index(column + kCorners[k][0], row + kCorners[k][1])] - value);
      std::array<Vec2, 4> crossings{};
      std::size_t count = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t next = (k + 1) % 4;
        if ((over[k] < 0) == (over[next] < 0)) continue;
        const Vec2 from = grid.node(column + kCorners[k][0], row + kCorners[k][1]);
        const Vec2 to = grid.node(column + kCorners[next][0], row + kCorners[next][1]);
        crossings[count++] = from + (to - from) * (over[k] / (over[k] - over[next]));
      }
      if (count == 2) {
        contour.push_back({crossings[0], crossings[1]});
      } else if (count == 4) {  // opposite corners alike: the mean decides which pair joins
        const bool joined = (over[0] + over[1] + over[2] + over[3] < 0) == (over[0] < 0);
        contour.push_back({crossings[0], crossings[joined ? 1 : 3]});
        contour.push_back({crossings[2], crossings[joined ? 3 : 1]});
      }
    }
  }
  return contour;
}

}  // namespace qrelief
