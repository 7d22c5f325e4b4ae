// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/arrangement.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numeric>

#include "support/shapes.h"

namespace qrelief {
namespace {

const ProjectionFrame kFrame = makeFrame({0.123, 0.456, 0}, {0, 0, 1}, {0.2, 1, 0}, 250);

struct Case {
  Footprint footprint;
  OutlineGraph graph;
  Result<Arrangement> arrangement;
};

Case arrangeOnPlate(const DepthLevels& levels, Vec2 plateSize, int n) {
  const Mesh mesh = shapes::plate(plateSize, 5, n, n);
  std::vector<std::uint32_t> patch(static_cast<std::size_t>(2 * n * n));
  std::iota(patch.begin(), patch.end(), 0u);
  Footprint footprint = findFootprint(mesh, kFrame, patch, levels, 0.1).value();
  std::vector<EdgeGrid::Edge> edges;
  for (const Footprint::Edge& e : footprint.edges) edges.push_back({footprint.points[e.a], footprint.points[e.b]});
  EdgeGrid grid(edges);
  OutlineGraph graph = buildOutlines(levels, 0.1, 1000);
  auto arrangement = arrange(footprint, grid, graph);
  return {std::move(footprint), std::move(graph), std::move(arrangement)};
}

DepthLevels patternLevels() {
  DepthLevels levels{6, 12, {}};
  for (int k = 0; k < 36; ++k) levels.level.push_back(k % 6 < 3 ? k / 12 : 5 * (k / 18));
  return levels;
}

double area(const Arrangement& a, std::size_t t) {
  const Vec2 p = a.points[a.triangles[t][0]];
  return cross2(a.points[a.triangles[t][1]] - p, a.points[a.triangles[t][2]] - p) / 2;
}

TEST(Arrangement, CoversEveryFacetAndEveryDepthExactly) {
  const DepthLevels levels = patternLevels();
  const Case c = arrangeOnPlate(levels, {17, 19}, 7);
  ASSERT_TRUE(c.arrangement) << c.arrangement.error().message;
  std::map<int, double> expectedOfLevel, ofLevel;
  for (const int level : levels.level)
    if (level > 0) expectedOfLevel[level] += 4;
  std::vector<double> ofFacet(c.footprint.facets.size(), 0.0);
  for (std::size_t t = 0; t < c.arrangement->triangles.size(); ++t) {
    EXPECT_GT(area(*c.arrangement, t), 0);
    ofFacet[c.arrangement->facets[t]] += area(*c.arrangement, t);
    if (c.arrangement->levels[t] > 0) ofLevel[c.arrangement->levels[t]] += area(*c.arrangement, t);
  }
  ASSERT_EQ(ofLevel.size(), expectedOfLevel.size());
  for (const auto& [level, expected] : expectedOfLevel)
    EXPECT_NEAR(ofLevel[level], expected, 1e-9) << "level " << level;
  for (std::size_t f = 0; f < ofFacet.size(); ++f) {
    const Triangle& t = c.footprint.corners[f];
    const Vec2 p = c.footprint.points[t[0]];
    EXPECT_NEAR(ofFacet[f], cross2(c.footprint.points[t[1]] - p, c.footprint.points[t[2]] - p) / 2, 1e-9);
  }
}

TEST(Arrangement, PutsCrossingsOnTheirEdgeAndTheirOutline) {
  const Case c = arrangeOnPlate(patternLevels(), {17, 19}, 7);
  ASSERT_TRUE(c.arrangement);
  ASSERT_GT(c.arrangement->crossings.size(), 40u);
  for (std::size_t k = 0; k < c.arrangement->crossings.size(); ++k) {
    const Arrangement::Crossing& crossing = c.arrangement->crossings[k];
    const Outline& outline = c.graph.outlines[crossing.outline];
    const Vec2 from = c.graph.nodes[outline.from];
    const Vec2 onOutline = from + (c.graph.nodes[outline.to] - from) * crossing.alongOutline;
    EXPECT_NEAR(glm::length(c.arrangement->points[c.arrangement->firstCrossing + k] - onOutline), 0, 1e-12);
  }
}

TEST(Arrangement, CutsOutlinesIntoPiecesThatAddUp) {
  const Case c = arrangeOnPlate(patternLevels(), {17, 19}, 7);
  ASSERT_TRUE(c.arrangement);
  double pieces = 0, outlines = 0;
  for (const auto& p : c.arrangement->pieces)
    pieces += glm::length(c.arrangement->points[p.to] - c.arrangement->points[p.from]);
  for (const auto& o : c.graph.outlines) outlines += glm::length(c.graph.nodes[o.to] - c.graph.nodes[o.from]);
  EXPECT_NEAR(pieces, outlines, 1e-9);
  EXPECT_EQ(c.arrangement->pieces.size(), c.graph.outlines.size() + c.arrangement->crossings.size());
}

TEST(Arrangement, DetectsAnOutlineThatLeavesTheFootprint) {
  const Case c = arrangeOnPlate(patternLevels(), {17, 11}, 3);
  ASSERT_FALSE(c.arrangement);
  EXPECT_EQ(c.arrangement.error().kind, ErrorKind::NoSolution);
}

}  // namespace
}  // namespace qrelief
