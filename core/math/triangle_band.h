// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

namespace qrelief {

/// Wider triangles, in texels, are drawn by rangeInBand(), narrower ones faster without it.
inline constexpr int kNarrowTexels = 8;

/// Least and greatest x; least > greatest: none.
template <typename Number>
struct BandRange {
  Number least, greatest;
};

/// Returns the range of x of the part of a triangle with y from `low` to `high`. Drawing a long and thin triangle row by
/// row within these ranges costs its perimeter, not the area of its bounding box.
/// @param a, b, c  corners with members x and y
template <typename Number, typename Point>
BandRange<Number> rangeInBand(const Point& a, const Point& b, const Point& c, Number low, Number high) {
  BandRange<Number> range{std::numeric_limits<Number>::infinity(), -std::numeric_limits<Number>::infinity()};
  const auto add = [&](Number x) {
    range.least = std::min(range.least, x);
    range.greatest = std::max(range.greatest, x);
  };
  const auto addEdge = [&](const Point& from, const Point& to) {
    if (from.y >= low && from.y <= high) add(from.x);
    for (const Number y : {low, high})
      if ((from.y < y) != (to.y < y)) add(from.x + (to.x - from.x) * ((y - from.y) / (to.y - from.y)));
  };
  addEdge(a, b);
  addEdge(b, c);
  addEdge(c, a);
  return range;
}

}  // namespace qrelief
