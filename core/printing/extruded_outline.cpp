// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/extruded_outline.h"

#include <algorithm>
#include <cmath>

#include "printing/distance_rows.h"

namespace qrelief {
namespace {

/// Slope of the distance below which a node lies in the middle of a thin wall, where two walls are equally far. Across
/// the bisector of a right corner the slope is 0.71.
constexpr double kRidgeSlope = 0.6;
/// Length of the shortest line that is laid, in its widths.
constexpr double kShortestLine = 0.5;
/// Steps beyond a line up to which drawing it needs distances: the diagonal of a cell, rounded up.
constexpr double kMoreSteps = 1.5;

/// Returns the first node at or beyond a coordinate, 0 … count.
int nodeFrom(double coordinate, double origin, double stepMm, int count) {
  return static_cast<int>(std::clamp(std::ceil((coordinate - origin) / stepMm), 0.0, static_cast<double>(count)));
}

/// Returns the segments with air on one side: where solids overlap, other segments run through plastic.
std::vector<Segment2> outsideOnly(std::span<const Segment2> outline, const LayerGrid& grid,
                                  const std::vector<std::int16_t>& numbers) {
  const bool overlaps = std::any_of(numbers.begin(), numbers.end(), [](int number) { return number > 1; });
  if (!overlaps) return {outline.begin(), outline.end()};
  const auto isSolid = [&](Vec2 at) {
    const Vec2 place = glm::round((at - grid.origin) / grid.stepMm);
    const int column = std::clamp(static_cast<int>(place.x), 0, grid.columns - 1);
    const int row = std::clamp(static_cast<int>(place.y), 0, grid.rows - 1);
    return numbers[grid.index(column, row)] > 0;
  };
  constexpr double kPieceSteps = 4;  // length of the pieces tested: only a part of a segment may run through plastic
  std::vector<Segment2> segments;
  for (const auto& [a, b] : outline) {
    const double length = glm::distance(a, b);
    const Vec2 across = Vec2(a.y - b.y, b.x - a.x) * (grid.stepMm / std::max(length, 1e-12));
    const int pieces = static_cast<int>(std::ceil(length / (kPieceSteps * grid.stepMm)));
    for (int k = 0; k < pieces; ++k) {
      const Segment2 piece{a + (b - a) * (1.0 * k / pieces), a + (b - a) * ((k + 1.0) / pieces)};
      const Vec2 middle = (piece[0] + piece[1]) / 2.0;
      if (isSolid(middle + across) != isSolid(middle - across)) segments.push_back(piece);
    }
  }
  return segments;
}

/// Nodes in the middle of a part too thin for the outer wall.
struct Ridge {
  std::vector<std::size_t> nodes;
  double lengthMm = 0;  ///< from end to end
};

std::vector<Ridge> thinRidges(const LayerGrid& solid, const LayerGrid& extruded, double thinnestMm) {
  const std::size_t nodes = solid.distanceMm.size();
  if (!anyThin(extruded.distanceMm.data(), solid.distanceMm.data(), static_cast<float>(-thinnestMm / 2), nodes))
    return {};
  std::vector<std::uint8_t> isRidge(nodes, 0);
  for (int row = 1; row + 1 < solid.rows; ++row)
    for (int column = 1; column + 1 < solid.columns; ++column) {
      const std::size_t i = solid.index(column, row);
      if (extruded.distanceMm[i] <= 0 || solid.distanceMm[i] > -thinnestMm / 2) continue;
      const auto columns = static_cast<std::size_t>(solid.columns);
      const double x = static_cast<double>(solid.distanceMm[i + 1] - solid.distanceMm[i - 1]);
      const double y = static_cast<double>(solid.distanceMm[i + columns] - solid.distanceMm[i - columns]);
      isRidge[i] = std::hypot(x, y) < kRidgeSlope * 2 * solid.stepMm;
    }
  std::vector<Ridge> ridges;
  std::vector<std::size_t> open;
  for (std::size_t start = 0; start < isRidge.size(); ++start) {
    if (!isRidge[start]) continue;
    Ridge ridge;
    Vec2 low{1e9}, high{-1e9};
    isRidge[start] = 0;
    open.push_back(start);
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      ridge.nodes.push_back(i);
      const int column = static_cast<int>(i % static_cast<std::size_t>(solid.columns));
      const int row = static_cast<int>(i / static_cast<std::size_t>(solid.columns));
      low = glm::min(low, solid.node(column, row));
      high = glm::max(high, solid.node(column, row));
      for (int k = 0; k < 9; ++k) {  // no ridge lies on the grid's border
        const std::size_t other = solid.index(column + k % 3 - 1, row + k / 3 - 1);
        if (!isRidge[other]) continue;
        isRidge[other] = 0;
        open.push_back(other);
      }
    }
    ridge.lengthMm = glm::distance(low, high);
    ridges.push_back(std::move(ridge));
  }
  return ridges;
}

/// Lowers distances to the distance from a disc, where that is at most `beyondMm`.
void addDisc(LayerGrid& grid, Vec2 centre, double radiusMm, double beyondMm) {
  const double reach = radiusMm + beyondMm;
  const Vec2 low = (centre - grid.origin - reach) / grid.stepMm, high = (centre - grid.origin + reach) / grid.stepMm;
  for (int row = std::max(0, static_cast<int>(std::ceil(low.y))); row <= std::min(grid.rows - 1.0, high.y); ++row)
    for (int column = std::max(0, static_cast<int>(std::ceil(low.x))); column <= std::min(grid.columns - 1.0, high.x);
         ++column) {
      float& held = grid.distanceMm[grid.index(column, row)];
      held = std::min(held, static_cast<float>(glm::distance(grid.node(column, row), centre) - radiusMm));
    }
}

/// Removes everything within a distance of the solid's outline, then adds the same distance round the rest; a negative
/// distance adds first and then removes.
/// @param solid     distances exact up to the distance
/// @param byMm      not 0
/// @param beyondMm  distances from the result are exact up to this
LayerGrid opened(const LayerGrid& solid, double byMm, double beyondMm) {
  // Outside the result up to beyondMm; inside far enough that its outline lies between known nodes.
  const double reach = std::max(byMm + beyondMm, kMoreSteps * solid.stepMm - byMm);
  LayerGrid result{solid.origin, solid.stepMm, solid.columns, solid.rows, {}};
  setDistances(result, contourOf(solid, -byMm), reach, solid.distanceMm, -byMm, byMm);
  return result;
}

}  // namespace

std::vector<std::int16_t> windingNumbers(std::span<const Segment2> outline, const LayerWindow& window, Vec2 corner,
                                         int winding) {
  const auto index = [&](int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(window.columns) + static_cast<std::size_t>(column);
  };
  std::vector<std::int16_t> numbers(index(0, window.rows), 0);
  std::vector<int> atRow(static_cast<std::size_t>(window.rows) + 1, 0);  // changes along the way up
  const auto add = [&](int column, int row, int change) {
    if (column < window.columns)
      numbers[index(column, row)] = static_cast<std::int16_t>(numbers[index(column, row)] + change);
  };
  for (const auto& [a, b] : outline) {
    const auto crossing = [](double from, double to, double at, double fromOther, double toOther) {
      return fromOther + (toOther - fromOther) * ((at - from) / (to - from));
    };
    if ((a.x <= corner.x) != (b.x <= corner.x)) {
      const double y = crossing(a.x, b.x, corner.x, a.y, b.y);
      if (y > corner.y)
        atRow[static_cast<std::size_t>(nodeFrom(y, window.origin.y, window.stepMm, window.rows))] += b.x > a.x ? 1 : -1;
    }
    const int begin = nodeFrom(std::min(a.y, b.y), window.origin.y, window.stepMm, window.rows);
    const int end = nodeFrom(std::max(a.y, b.y), window.origin.y, window.stepMm, window.rows);
    for (int row = begin; row < end; ++row) {
      const double x = crossing(a.y, b.y, window.origin.y + window.stepMm * row, a.x, b.x);
      if (x > corner.x) add(nodeFrom(x, window.origin.x, window.stepMm, window.columns), row, b.y > a.y ? -1 : 1);
    }
  }
  int left = winding;
  for (int row = 0; row < window.rows; ++row) {
    left += atRow[row];
    int number = left;
    for (int column = 0; column < window.columns; ++column) {
      number += numbers[index(column, row)];
      numbers[index(column, row)] = static_cast<std::int16_t>(number);
    }
  }
  return numbers;
}

LayerGrid layOutline(std::span<const Segment2> outline, const LayerWindow& window, Vec2 corner, int winding,
                     const PrintProcess& process) {
  const double reach = process.cornerRadiusMm + kMoreSteps * window.stepMm;
  LayerGrid solid{window.origin, window.stepMm, window.columns, window.rows, {}};
  const std::vector<std::int16_t> numbers = windingNumbers(outline, window, corner, winding);
  std::vector<float> outside(numbers.size());  // less than 0 inside
  std::transform(numbers.begin(), numbers.end(), outside.begin(),
                 [](int number) { return static_cast<float>(-number); });
  setDistances(solid, outsideOnly(outline, solid, numbers), reach, outside, 0, 0);

  const double closingMm = process.pocketRadiusMm + kMoreSteps * window.stepMm;
  LayerGrid extruded = opened(solid, process.cornerRadiusMm, closingMm);
  if (process.thinnestLineMm > 0)
    for (const Ridge& ridge : thinRidges(solid, extruded, process.thinnestWallMm)) {
      if (ridge.lengthMm < kShortestLine * process.thinnestLineMm) continue;
      for (const std::size_t i : ridge.nodes) {
        const auto columns = static_cast<std::size_t>(window.columns);
        addDisc(extruded, extruded.node(static_cast<int>(i % columns), static_cast<int>(i / columns)),
                std::max(process.thinnestLineMm / 2, static_cast<double>(-solid.distanceMm[i])), closingMm);
      }
    }
  return opened(extruded, -process.pocketRadiusMm, kExtrudedReachMm);
}

}  // namespace qrelief
