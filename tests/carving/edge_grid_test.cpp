// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/edge_grid.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace qrelief {
namespace {

bool segmentMeetsBox(const EdgeGrid::Edge& e, Vec2 lo, Vec2 hi) {
  double t0 = 0, t1 = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double from = e[0][axis], step = e[1][axis] - from;
    if (step == 0) {
      if (from < lo[axis] || from > hi[axis]) return false;
      continue;
    }
    const double a = (lo[axis] - from) / step, b = (hi[axis] - from) / step;
    t0 = std::max(t0, std::min(a, b));
    t1 = std::min(t1, std::max(a, b));
  }
  return t0 <= t1;
}

TEST(EdgeGrid, FindsEveryEdgeThatABoxMeetsOnce) {
  std::mt19937 random(7);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<EdgeGrid::Edge> edges;
  for (int k = 0; k < 500; ++k) {
    const Vec2 a(40 * unit() - 20, 10 * unit());
    const double length = k % 10 == 0 ? 30 : 1;
    edges.push_back({a, a + Vec2(unit() - 0.5, unit() - 0.5) * length});
  }
  edges.push_back({Vec2(-3, 0), Vec2(-3, 10)});  // vertical
  edges.push_back({Vec2(-20, 5), Vec2(20, 5)});  // horizontal
  EdgeGrid grid(edges);
  for (int k = 0; k < 300; ++k) {
    const Vec2 lo(50 * unit() - 25, 14 * unit() - 2);
    const Vec2 hi = lo + Vec2(unit(), unit()) * (k % 7 == 0 ? 10.0 : 0.3);
    const auto view = grid.near(lo, hi);
    std::vector<std::uint32_t> found(view.begin(), view.end());
    std::sort(found.begin(), found.end());
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      if (!segmentMeetsBox(edges[e], lo, hi)) continue;
      EXPECT_TRUE(std::binary_search(found.begin(), found.end(), e)) << "edge " << e << ", box " << k;
    }
  }
}

TEST(EdgeGrid, ReturnsOnlyAFewOfManyShortEdges) {
  std::vector<EdgeGrid::Edge> edges;
  for (int row = 0; row < 100; ++row)
    for (int column = 0; column < 100; ++column) edges.push_back({Vec2(column, row), Vec2(column + 1, row)});
  EdgeGrid grid(edges);
  EXPECT_LE(grid.near({50.2, 50.2}, {50.4, 50.4}).size(), 8u);
}

TEST(EdgeGrid, IsEmptyWithoutEdges) {
  EdgeGrid grid({});
  EXPECT_TRUE(grid.near({-1, -1}, {1, 1}).empty());
}

}  // namespace
}  // namespace qrelief
