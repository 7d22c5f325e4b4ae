// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace qrelief {

/// The part of a triangle between two heights. Drawing a long and thin triangle row by row within its bands costs its
/// length, not the area of its bounding box.
/// @tparam Number  float or double
template <typename Number>
class TriangleBands {
 public:
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

/// The texels of a square map whose middles may lie in a triangle, row by row. Texels are 1 wide, the first begins at
/// 0.
/// @tparam Number  float or double
template <typename Number>
class TriangleTexels {
 public:
  /// First and last texel; last < first: none.
  struct Range {
    int first, last;
  };

  /// @param a, b, c  corners with members x and y
  template <typename Point>
  TriangleTexels(const Point& a, const Point& b, const Point& c, int texels)
      : texels_(texels),
        columns_(within(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}))),
        rows_(within(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}))) {
    const int across = columns_.last - columns_.first;
    if (across >= kNarrow || (across >= 2 && rows_.last - rows_.first >= kNarrow)) bands_.emplace(a, b, c);
  }

  Range rows() const { return rows_; }
  /// Returns the columns of a row: some more than needed, because of rounding and because small triangles are drawn
  /// faster by their box.
  Range columns(int row) const {
    if (!bands_) return columns_;
    const Number middle = static_cast<Number>(row) + kHalf;
    const auto [least, greatest] = bands_->between(middle - kSlack, middle + kSlack);
    const Range range = within(least - kSlack, greatest + kSlack);
    return {std::max(columns_.first, range.first), std::min(columns_.last, range.last)};
  }

 private:
  static constexpr int kNarrow = 8;
  static constexpr Number kHalf = Number(0.5);
  static constexpr Number kSlack = Number(1) / 16;  // of a texel: allowance for rounding

  /// Clamps before the conversion to integers, because corners level with the eye lie far away.
  Range within(Number low, Number high) const {
    const auto end = static_cast<Number>(texels_);
    return {static_cast<int>(std::ceil(std::clamp(low - kHalf, Number(0), end))),
            static_cast<int>(std::floor(std::clamp(high - kHalf, Number(-1), end - 1)))};
  }

  int texels_;
  Range columns_, rows_;
  std::optional<TriangleBands<Number>> bands_;
};

}  // namespace qrelief
