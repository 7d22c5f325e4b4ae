// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/outline.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <string>

namespace qrelief {
namespace {

/// Parses rows of digits, the level of each submodule; submodules are 1 mm wide.
DepthLevels levelsOf(const std::vector<std::string>& rows) {
  DepthLevels levels;
  levels.size = static_cast<int>(rows.size());
  levels.symbolMm = levels.size;
  for (const std::string& row : rows)
    for (const char digit : row) levels.level.push_back(digit - '0');
  return levels;
}

double totalLength(const OutlineGraph& graph) {
  double length = 0;
  for (const Outline& o : graph.outlines) length += glm::length(graph.nodes[o.to] - graph.nodes[o.from]);
  return length;
}

/// Expects two walls on each stretch of each node's ray, i.e. two outlines with the half level on opposite sides.
void expectAtMostTwoWallsAnywhere(const OutlineGraph& graph) {
  std::map<std::pair<std::uint32_t, int>, int> walls;  // node, stretch below a level
  for (const Outline& o : graph.outlines)
    for (const std::uint32_t node : {o.from, o.to})
      for (int level = std::min(o.left, o.right); level < std::max(o.left, o.right); ++level) ++walls[{node, level}];
  for (const auto& [where, count] : walls) EXPECT_EQ(count, 2) << "node " << where.first << ", level " << where.second;
}

constexpr int kAnyLength = 1000;

TEST(Outline, RunsOnceAroundASingleSubmodule) {
  const OutlineGraph graph = buildOutlines(levelsOf({"000", "030", "000"}), 0.04, kAnyLength);
  EXPECT_EQ(graph.nodes.size(), 4u);
  ASSERT_EQ(graph.outlines.size(), 4u);
  EXPECT_DOUBLE_EQ(totalLength(graph), 4);
  for (const Outline& o : graph.outlines) {
    EXPECT_EQ(o.left + o.right, 3);
    // The centre lies on the carved side.
    const Vec2 from = graph.nodes[o.from];
    const bool centreLeft = cross2(graph.nodes[o.to] - from, -from) > 0;
    EXPECT_EQ(centreLeft ? o.left : o.right, 3);
  }
}

TEST(Outline, PassesStraightCornersWithoutANode) {
  const OutlineGraph graph = buildOutlines(levelsOf({"2222", "2222", "2222", "2222"}), 0.04, kAnyLength);
  EXPECT_EQ(graph.nodes.size(), 4u);
  EXPECT_EQ(graph.outlines.size(), 4u);
  EXPECT_DOUBLE_EQ(totalLength(graph), 16);
}

TEST(Outline, GetsNodesInBetweenIfItsLengthIsLimited) {
  const OutlineGraph graph = buildOutlines(levelsOf({"2222", "2222", "2222", "2222"}), 0.04, 2);
  EXPECT_EQ(graph.nodes.size(), 8u);
  EXPECT_EQ(graph.outlines.size(), 8u);
  EXPECT_DOUBLE_EQ(totalLength(graph), 16);
}

TEST(Outline, HasANodeWhereAnAdjacentDepthChanges) {
  const OutlineGraph graph = buildOutlines(levelsOf({"12", "12"}), 0.04, kAnyLength);
  EXPECT_EQ(graph.nodes.size(), 6u);  // four corners, and two nodes where the dividing line meets the rim
  EXPECT_EQ(graph.outlines.size(), 7u);
}

TEST(Outline, IsEmptyWithoutCarving) {
  const OutlineGraph graph = buildOutlines(levelsOf({"00", "00"}), 0.04, kAnyLength);
  EXPECT_TRUE(graph.nodes.empty());
  EXPECT_TRUE(graph.outlines.empty());
}

TEST(Outline, SeparatesPocketsThatTouchAtACornerByTheChamfer) {
  for (const std::vector<std::string>& rows : {std::vector<std::string>{"30", "03"}, {"03", "30"}}) {
    const OutlineGraph graph = buildOutlines(levelsOf(rows), 0.1, kAnyLength);
    ASSERT_EQ(graph.nodes.size(), 8u);
    EXPECT_EQ(graph.outlines.size(), 8u);
    std::vector<Vec2> middle;
    for (const Vec2 p : graph.nodes)
      if (glm::length(p) < 0.5) middle.push_back(p);
    ASSERT_EQ(middle.size(), 2u);
    EXPECT_NEAR(glm::length(middle[0] - middle[1]), 0.1, 1e-12);
    const double deepDiagonal = rows[0] == "30" ? -1 : 1;  // u·v along it
    EXPECT_GT(deepDiagonal * middle[0].x * middle[0].y, 0);
    expectAtMostTwoWallsAnywhere(graph);
  }
}

TEST(Outline, RunsBetweenTheNodesOfASaddleWhoseShallowSidesDiffer) {
  const OutlineGraph graph = buildOutlines(levelsOf({"51", "26"}), 0.1, kAnyLength);
  int between = 0;
  for (const Outline& o : graph.outlines) {
    if (std::abs(glm::length(graph.nodes[o.to] - graph.nodes[o.from]) - 0.1) > 1e-9) continue;
    ++between;
    // Seen along the outline, the upper right cell's side has level 1, the other side 2.
    const Vec2 along = graph.nodes[o.to] - graph.nodes[o.from];
    const bool upperRightIsLeft = cross2(along, Vec2(1, 1)) > 0;
    EXPECT_EQ(upperRightIsLeft ? o.left : o.right, 1);
    EXPECT_EQ(upperRightIsLeft ? o.right : o.left, 2);
  }
  EXPECT_EQ(between, 1);
  expectAtMostTwoWallsAnywhere(graph);
}

/// Calls a check for all ways in which four depths can meet.
void forAllFourDepths(const std::function<void(const std::vector<std::string>&)>& check) {
  for (int code = 0; code < 256; ++code) {
    std::vector<std::string> rows{"00", "00"};
    for (int k = 0; k < 4; ++k)
      rows[static_cast<std::size_t>(k / 2)][static_cast<std::size_t>(k % 2)] =
          static_cast<char>('0' + (code >> 2 * k) % 4);
    SCOPED_TRACE(rows[0] + "/" + rows[1]);
    check(rows);
  }
}

/// Proves the header's claim by exhaustion.
TEST(Outline, LeavesTwoWallsOnEveryStretchOfEveryRayForAllFourDepths) {
  forAllFourDepths([](const std::vector<std::string>& rows) {
    expectAtMostTwoWallsAnywhere(buildOutlines(levelsOf(rows), 0.1, kAnyLength));
  });
}

TEST(GridOutline, HasANodeAtEveryCornerAndAClosedBorder) {
  const OutlineGraph graph = buildGridOutlines(levelsOf({"000", "030", "000"}), 0.04);
  EXPECT_EQ(graph.nodes.size(), 16u);
  std::size_t border = 0, inner = 0;
  for (const Outline& o : graph.outlines) {
    const Vec2 from = graph.nodes[o.from], to = graph.nodes[o.to];
    const bool centreLeft = cross2(to - from, -from) > 0;
    if (o.boundsGrid()) {
      ++border;
      EXPECT_TRUE(o.meetsModel());
      EXPECT_EQ(o.leftResampled, centreLeft);
      EXPECT_EQ(std::max(std::abs(from.x + to.x), std::abs(from.y + to.y)), 3);  // twice the half edge
    } else {
      ++inner;
      EXPECT_FALSE(o.meetsModel());
      EXPECT_EQ(centreLeft ? o.left : o.right, 3);
    }
  }
  EXPECT_EQ(border, 12u);
  EXPECT_EQ(inner, 4u);
}

TEST(GridOutline, MovesOnlyNodesOfTheBorder) {
  const OutlineGraph graph = buildGridOutlines(levelsOf({"303", "030", "303"}), 0.04);
  EXPECT_EQ(graph.nodes.size(), 16u + 4u);  // the inner corners are saddles
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    const bool onBorder = std::max(std::abs(graph.nodes[n].x), std::abs(graph.nodes[n].y)) == 1.5;
    EXPECT_EQ(graph.leewayMm[n] > 0, onBorder) << n;
  }
}

TEST(GridOutline, LeavesTwoWallsOnEveryStretchOfEveryRayForAllFourDepths) {
  forAllFourDepths([](const std::vector<std::string>& rows) {
    expectAtMostTwoWallsAnywhere(buildGridOutlines(levelsOf(rows), 0.1));
  });
}

}  // namespace
}  // namespace qrelief
