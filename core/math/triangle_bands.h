// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <limits>

namespace qrelief {

/// The part of a triangle between two heights. Drawing a long and thin triangle row by row within its bands costs its
/// length, not the area of its bounding box.
/// @tparam Number  float or double
template <typename Number>
class TriangleBands {
 public:
  /// Triangles that are wider, in texels, are drawn faster with their bands than without.
  static constexpr int kNarrowTexels = 8;

  /// Least and greatest x; least > greatest: none.
  struct Range {
    Number least, greatest;
  };

  /// @param a, b, c  corners with members x and y; may lie on a line or on a point
  template <typename Point>
  TriangleBands(const Point& a, const Point& b, const Point& c) : edges_{edge(a, b), edge(b, c), edge(c, a)} {}

  /// Returns the range of x with y from `low` to `high`, up to rounding.
  Range between(Number low, Number high) const {
    constexpr Number kFar = std::numeric_limits<Number>::infinity();
    Range range{kFar, -kFar};
    for (const Edge& e : edges_) {
      const Number from = std::max(low, e.low), to = std::min(high, e.high);
      if (!(from <= to)) continue;
      const Number x0 = e.xAtLow + (from - e.low) * e.slope, x1 = e.xAtLow + (to - e.low) * e.slope;
      range.least = std::min({range.least, x0, x1});
      range.greatest = std::max({range.greatest, x0, x1});
    }
    return range;
  }

 private:
  struct Edge {
    Number low, high, xAtLow, slope;  // slope: dx / dy
  };

  /// Of a level edge only the first corner counts: the second one is the first of the next edge.
  template <typename Point>
  static Edge edge(const Point& p, const Point& q) {
    if (p.y == q.y) return {p.y, p.y, p.x, 0};
    const Number slope = (q.x - p.x) / (q.y - p.y);
    return p.y < q.y ? Edge{p.y, q.y, p.x, slope} : Edge{q.y, p.y, q.x, slope};
  }

  std::array<Edge, 3> edges_;
};

}  // namespace qrelief
