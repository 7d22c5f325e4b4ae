// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/clearance.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace qrelief {
namespace {

constexpr double kSnap = 0.01;

OutlineGraph squareOutline(double half) {
  OutlineGraph graph;
  graph.nodes = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  graph.leewayMm.assign(4, 0.1);
  for (std::uint32_t k = 0; k < 4; ++k) graph.outlines.push_back({k, (k + 1) % 4, 1, 0});
  return graph;
}

TEST(Clearance, LeavesNodesUnchangedIfNothingIsNear) {
  OutlineGraph graph = squareOutline(1);
  const std::vector<Vec2> before = graph.nodes;
  EdgeGrid edges({{Vec2(-5, -4.7), Vec2(5, 4.9)}, {Vec2(-0.4, -0.2), Vec2(0.1, 0.3)}});
  Clearance clearance(graph, edges, kSnap);
  clearance.placeAll();
  EXPECT_EQ(graph.nodes, before);
  EXPECT_EQ(clearance.smallest(), clearance.plentyMm());
}

TEST(Clearance, MovesNodesOffAModelVertexByLessThanTheSnap) {
  OutlineGraph graph = squareOutline(1);
  const std::vector<Vec2> before = graph.nodes;
  EdgeGrid edges({{Vec2(1, 1), Vec2(3, 2)}, {Vec2(1, 1), Vec2(0, 0.3)}});
  Clearance clearance(graph, edges, kSnap);
  EXPECT_EQ(clearance.smallest(), 0);
  clearance.placeAll();
  EXPECT_GE(clearance.smallest(), clearance.plentyMm());
  for (std::size_t k = 0; k < 4; ++k) EXPECT_LE(glm::length(graph.nodes[k] - before[k]), kSnap);
  EXPECT_NE(graph.nodes[2], before[2]);
}

TEST(Clearance, FreesOutlinesThatRunExactlyAlongAGridOfModelEdges) {
  std::vector<EdgeGrid::Edge> lines;
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j < 4; ++j) {
      const double a = i * 0.5, b = j * 0.5;
      lines.push_back({Vec2(a, b), Vec2(a, b + 0.5)});
      lines.push_back({Vec2(b, a), Vec2(b + 0.5, a)});
      if (i < 4) lines.push_back({Vec2(a, b), Vec2(a + 0.5, b + 0.5)});
    }
  EdgeGrid edges(lines);
  OutlineGraph graph = squareOutline(1);
  Clearance clearance(graph, edges, kSnap);
  clearance.placeAll();
  EXPECT_GT(clearance.smallest(), 2e-4);
}

TEST(Clearance, TriesOtherRandomPositionsOnRequest) {
  OutlineGraph graph = squareOutline(1);
  const std::vector<Vec2> before = graph.nodes;
  EdgeGrid edges({{Vec2(5, 5), Vec2(6, 5)}});
  Clearance clearance(graph, edges, kSnap);
  clearance.placeAll();
  const std::vector<std::uint32_t> again{1};
  clearance.placeAgain(again);
  const Vec2 first = graph.nodes[1];
  clearance.placeAgain(again);
  EXPECT_NE(first, before[1]);
  EXPECT_NE(graph.nodes[1], first);
  EXPECT_LE(glm::length(graph.nodes[1] - before[1]), kSnap);
  EXPECT_EQ(graph.nodes[0], before[0]);
}

TEST(Clearance, MovesFartherWithEveryTryButNeverBeyondTheLeeway) {
  OutlineGraph graph = squareOutline(1);
  const std::vector<Vec2> before = graph.nodes;
  std::vector<EdgeGrid::Edge> fan;  // so dense that no point within the snap distance is clear
  for (int k = 0; k < 2000; ++k)
    fan.push_back({Vec2(1, 1), Vec2(1 + 3 * std::cos(k * 3.1416e-3), 1 + 3 * std::sin(k * 3.1416e-3))});
  EdgeGrid edges(fan);
  Clearance clearance(graph, edges, kSnap);
  clearance.placeAll();
  EXPECT_LE(glm::length(graph.nodes[2] - before[2]), kSnap);
  double farthest = 0;
  for (int k = 0; k < 100; ++k) {
    clearance.placeAgain(std::vector<std::uint32_t>{2});
    farthest = std::max(farthest, glm::length(graph.nodes[2] - before[2]));
  }
  EXPECT_GT(farthest, 2 * kSnap);
  EXPECT_LE(farthest, graph.leewayMm[2]);
}

}  // namespace
}  // namespace qrelief
