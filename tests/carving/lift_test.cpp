// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/lift.h"

#include <cmath>
#include <gtest/gtest.h>

namespace qrelief {
namespace {

const ProjectionFrame kFrame = makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 100);

/// Hand-made mesh with its projection and overlay.
struct Scene {
  Mesh mesh;
  Footprint footprint;
  Arrangement arrangement;
};

/// Returns a facet that an outline cuts in two, from corner 0 to a crossing on the opposite edge 1-2.
Scene halvedFacet(int leftLevel, int rightLevel) {
  Scene s;
  s.mesh.positions = {{-1, 0, 3}, {1, -1, 3}, {1, 1, 7}};
  s.mesh.triangles = {{0, 1, 2}};
  s.footprint.facets = {0};
  s.footprint.vertices = {0, 1, 2};
  for (const Vec3f& p : s.mesh.positions) s.footprint.points.push_back(kFrame.project(Vec3(p)));
  s.footprint.corners = {{0, 1, 2}};
  s.footprint.edges = {{0, 1, 0, kNoFacet}, {1, 2, 0, kNoFacet}, {2, 0, 0, kNoFacet}};
  s.arrangement.points = s.footprint.points;
  s.arrangement.firstNode = s.arrangement.firstCrossing = 3;
  s.arrangement.crossings = {{1, 0, 0.25, 0.5}};
  s.arrangement.points.push_back(s.footprint.points[1] * 0.75 + s.footprint.points[2] * 0.25);
  s.arrangement.pieces = {{0, 3, leftLevel, rightLevel}};
  s.arrangement.triangles = {{0, 3, 2}, {0, 1, 3}};
  s.arrangement.facets = {0, 0};
  s.arrangement.levels = {leftLevel, rightLevel};
  return s;
}

TEST(Lift, KeepsModelVerticesOfUncarvedPartsBitForBit) {
  const Scene s = halvedFacet(30, 0);
  const LiftedSurface surface = lift(s.mesh, kFrame, s.footprint, s.arrangement);
  for (std::size_t v = 0; v < surface.vertices.size(); ++v)
    if (surface.vertices[v].point < 3 && surface.vertices[v].level == 0) {
      EXPECT_EQ(surface.positions[v], s.mesh.positions[surface.vertices[v].point]);
    }
}

TEST(Lift, MovesEachPointAlongItsRayByExactlyTheDepth) {
  const Scene s = halvedFacet(30, 10);
  const LiftedSurface surface = lift(s.mesh, kFrame, s.footprint, s.arrangement);
  ASSERT_EQ(surface.vertices.size(), 3u + 2u + 2u + 3u);  // the surface itself is a level at every point
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    const auto [point, level] = surface.vertices[v];
    const Vec3 lifted(surface.positions[v]);
    EXPECT_NEAR(glm::length(kFrame.project(lifted) - s.arrangement.points[point]), 0, 1e-6);
    if (point == 3) continue;
    const double depth = glm::length(lifted - kFrame.eye()) - glm::length(Vec3(s.mesh.positions[point]) - kFrame.eye());
    EXPECT_NEAR(depth, depthOfLevel(level), 1e-5);
  }
}

TEST(Lift, PlacesACrossingOnItsEdgeInSpace) {
  // The edge rises towards the eye, so the first quarter of its image is more than a quarter of its length in space.
  const Scene s = halvedFacet(30, 0);
  const LiftedSurface surface = lift(s.mesh, kFrame, s.footprint, s.arrangement);
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    if (surface.vertices[v].point != 3 || surface.vertices[v].level != 0) continue;
    const double along = 0.25 * 97 / (0.25 * 97 + 0.75 * 93);
    EXPECT_NEAR(surface.positions[v].x, 1, 1e-6);
    EXPECT_NEAR(surface.positions[v].y, -1 + 2 * along, 1e-6);
    EXPECT_NEAR(surface.positions[v].z, 3 + 4 * along, 1e-6);
  }
}

TEST(Lift, TurnsWallsTowardsThePocket) {
  for (const bool pocketLeft : {true, false}) {
    const Scene s = pocketLeft ? halvedFacet(30, 0) : halvedFacet(0, 30);
    const LiftedSurface surface = lift(s.mesh, kFrame, s.footprint, s.arrangement);
    ASSERT_EQ(surface.triangles.size() - surface.firstWall, 2u);
    for (std::size_t t = surface.firstWall; t < surface.triangles.size(); ++t) {
      const Triangle& w = surface.triangles[t];
      const Vec3 a(surface.positions[w[0]]);
      const Vec3 normal = glm::cross(Vec3(surface.positions[w[1]]) - a, Vec3(surface.positions[w[2]]) - a);
      EXPECT_EQ(normal.y > 0, pocketLeft);  // the left half holds corner 2, at larger y
    }
  }
}

TEST(Lift, GivesAWallEveryDepthOfItsEnds) {
  // The crossing alone has a third level, as if a floor lay beyond the facet's edge.
  Scene s = halvedFacet(30, 0);
  s.arrangement.triangles.push_back({3, 1, 2});
  s.arrangement.facets.push_back(0);
  s.arrangement.levels.push_back(12);
  const LiftedSurface surface = lift(s.mesh, kFrame, s.footprint, s.arrangement);
  EXPECT_EQ(surface.triangles.size() - surface.firstWall, 3u);
  bool used = false;
  for (std::size_t t = surface.firstWall; t < surface.triangles.size(); ++t)
    for (const std::uint32_t v : surface.triangles[t])
      used = used || (surface.vertices[v].point == 3 && surface.vertices[v].level == 12);
  EXPECT_TRUE(used);
}

}  // namespace
}  // namespace qrelief
