// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/layer_grid.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <utility>

#include "support/instruction_sets.h"

namespace qrelief {
namespace {

LayerGrid gridOf(double stepMm, int nodes, float value) {
  LayerGrid grid{Vec2(-stepMm * (nodes - 1) / 2), stepMm, nodes, nodes, {}};
  grid.distanceMm.assign(static_cast<std::size_t>(nodes * nodes), value);
  return grid;
}

TEST(LayerGrid, DistancesWithinReachAreToTheNearestSegment) {
  LayerGrid grid = gridOf(0.1, 61, 9);
  const std::vector<Segment2> segments = {{Vec2(-1, 0), Vec2(1, 0.5)}, {Vec2(1, 0.5), Vec2(1, 2)}};
  std::vector<float> inside(grid.distanceMm.size());
  for (std::size_t i = 0; i < inside.size(); ++i) inside[i] = i % 3 == 0 ? -1.0f : 2.0f;
  setDistances(grid, segments, 0.7, inside, 1, 0.25);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const Vec2 at = grid.node(column, row);
      const double expected = std::min(distanceToSegment(at, segments[0]), distanceToSegment(at, segments[1]));
      const std::size_t node = grid.index(column, row);
      const double held = (static_cast<double>(grid.distanceMm[node]) + 0.25) * (node % 3 == 0 ? -1 : 1);
      if (expected <= 0.7)
        EXPECT_NEAR(held, expected, 1e-6);
      else
        EXPECT_GE(held, 0.7 - 1e-6);
    }
}

TEST(LayerGrid, IsTheSameForAllInstructionSets) {
  const std::vector<Segment2> segments = {{Vec2(-1, 0), Vec2(1, 0.5)}, {Vec2(1, 0.5), Vec2(1, 2)}};
  const std::vector<float> inside(61 * 61, 1.0f);
  expectSameByAllInstructionSets([&] {
    LayerGrid grid = gridOf(0.1, 61, 0);
    setDistances(grid, segments, 0.7, inside, 0, 0.25);
    return std::pair(grid.distanceMm, contourOf(grid, 0.1));
  });
}

TEST(LayerGrid, BetweenTheNodesItIsBilinear) {
  LayerGrid grid = gridOf(0.5, 11, 0);
  const auto plane = [](Vec2 p) { return 2 * p.x - 3 * p.y + 1; };
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      grid.distanceMm[grid.index(column, row)] = static_cast<float>(plane(grid.node(column, row)));
  for (const Vec2 at : {Vec2(0.13, -0.77), Vec2(-2.5, -2.5), Vec2(2.5, 2.5), Vec2(2.1, -2.4)})
    EXPECT_NEAR(grid.at(at), plane(at), 1e-5);
}

TEST(LayerGrid, TheContourOfTheDistancesToACircleIsTheCircle) {
  LayerGrid grid = gridOf(0.05, 121, 0);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      grid.distanceMm[grid.index(column, row)] = static_cast<float>(glm::length(grid.node(column, row)) - 2);
  double length = 0;
  for (const auto& [a, b] : contourOf(grid, -0.5)) {
    EXPECT_NEAR(glm::length(a), 1.5, 0.05 * 0.05);
    length += glm::distance(a, b);
  }
  EXPECT_NEAR(length, 2 * std::numbers::pi * 1.5, 0.01);
}

TEST(LayerGrid, TheMeanDecidesWhetherTouchingCornersAreJoined) {
  LayerGrid grid{Vec2(0), 1, 2, 2, {-3, 1, 1, -3}};  // the diagonal of inner corners is joined
  for (const auto& [a, b] : contourOf(grid, 0))
    EXPECT_LT(std::abs(a.x - a.y - b.x + b.y), 1e-9) << "round an outer corner";
  grid.distanceMm = {-1, 3, 3, -1};
  for (const auto& [a, b] : contourOf(grid, 0))
    EXPECT_LT(std::abs(a.x + a.y - b.x - b.y), 1e-9) << "round an inner one";
}

}  // namespace
}  // namespace qrelief
