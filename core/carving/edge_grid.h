// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "math/vec.h"

namespace qrelief {

/// Uniform bins over line segments in the plane, to find the segments near a place.
class EdgeGrid {
 public:
  using Edge = std::array<Vec2, 2>;

  /// Cost: O(edges + bins they cross); at most about 4 bins per edge.
  explicit EdgeGrid(std::vector<Edge> edges);

  const Edge& edge(std::uint32_t index) const { return edges_[index]; }

  /// Returns every edge that meets the box [lo, hi], and some others; each once, in an order that depends only on the
  /// input. The result is valid until the next call.
  std::span<const std::uint32_t> near(Vec2 lo, Vec2 hi);

 private:
  struct BinRange {
    int first, last;
  };
  BinRange binsAlong(int axis, double lo, double hi) const;
  template <class Visit>
  void visitBins(const Edge& edge, const Visit& visit) const;

  std::vector<Edge> edges_;
  Vec2 origin_{0};
  double binMm_ = 1;
  std::array<int, 2> bins_{1, 1};
  std::vector<std::uint32_t> firstEntry_, entries_;  // bin → edges
  std::vector<std::uint32_t> lastQuery_, found_;
  std::uint32_t query_ = 0;
};

}  // namespace qrelief
