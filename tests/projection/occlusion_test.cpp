// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/occlusion.h"

#include <array>
#include <gtest/gtest.h>

#include "support/facets.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

const ProjectionFrame kFrame = makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 100);

/// Facet (0, 0), (10, 0), (0, 10) at height 0, with arbitrary further vertices.
struct Scene {
  Mesh mesh;

  explicit Scene(std::vector<Vec3f> more = {}) {
    mesh.positions = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}};
    mesh.positions.insert(mesh.positions.end(), more.begin(), more.end());
    mesh.triangles = {{0, 1, 2}};
  }

  std::optional<Occluder> test(std::uint32_t from, std::uint32_t to) const {
    const EyeView view = viewFrom(mesh, kFrame, allFacets(mesh));
    const std::array<Vec3, 2> ends{Vec3(mesh.positions[from]), Vec3(mesh.positions[to])};
    const ContourEdge edge{ends, {from, to}, {kFrame.project(ends[0]), kFrame.project(ends[1])}};
    return occluderOf(mesh, 0, edge, kFrame.eye(), kFrame, view);
  }
};

void expectSegment(const Segment2& actual, Vec2 a, Vec2 b) {
  EXPECT_NEAR(glm::distance(actual[0], a), 0, 1e-9);
  EXPECT_NEAR(glm::distance(actual[1], b), 0, 1e-9);
}

TEST(Occluder, IsThePartOfTheEdgeInFrontOfTheFacet) {
  // At half the eye's height everything appears twice as large.
  const std::optional<Occluder> occluder = Scene({{-5, 1, 50}, {20, 1, 50}}).test(3, 4);
  ASSERT_TRUE(occluder);
  EXPECT_TRUE(occluder->crosses);
  expectSegment(occluder->segment, {0, 2}, {8, 2});
}

TEST(Occluder, MayBeTheWholeEdge) {
  const std::optional<Occluder> occluder = Scene({{1, 1, 50}, {2, 1, 50}}).test(3, 4);
  ASSERT_TRUE(occluder);
  EXPECT_TRUE(occluder->crosses);
  expectSegment(occluder->segment, {2, 2}, {4, 2});
}

TEST(Occluder, IsNoneBehindTheFacet) { EXPECT_FALSE(Scene({{-5, 1, -50}, {20, 1, -50}}).test(3, 4)); }

TEST(Occluder, IsNoneBesideTheFacet) {
  EXPECT_FALSE(Scene({{5.1f, 0, 50}, {5.1f, 9, 50}}).test(3, 4));
  EXPECT_FALSE(Scene({{5, 0.1f, 50}, {0.1f, 5, 50}}).test(3, 4)) << "beyond the slanted side, boxes overlapping";
}

TEST(Occluder, TouchesWhereItRunsAlongASideOrThroughACorner) {
  const std::optional<Occluder> along = Scene({{-5, 0, 50}, {3, 0, 50}}).test(3, 4);
  ASSERT_TRUE(along);
  EXPECT_FALSE(along->crosses);
  expectSegment(along->segment, {0, 0}, {6, 0});

  const std::optional<Occluder> through = Scene({{-5, 5, 50}, {5, -5, 50}}).test(3, 4);
  ASSERT_TRUE(through);
  EXPECT_FALSE(through->crosses);
  expectSegment(through->segment, {0, 0}, {0, 0});
}

TEST(Occluder, OfAnEdgeAtTheCornerIsACusp) {
  // Edges from corner 0: up and over the facet, along its side, away from it, and below it.
  const std::optional<Occluder> over = Scene({{1, 1, 50}}).test(0, 3);
  ASSERT_TRUE(over);
  EXPECT_TRUE(over->crosses);
  expectSegment(over->segment, {0, 0}, {2, 2});
  const std::optional<Occluder> along = Scene({{2, 0, 50}}).test(3, 0);
  ASSERT_TRUE(along);
  EXPECT_FALSE(along->crosses);
  expectSegment(along->segment, {4, 0}, {0, 0});
  EXPECT_FALSE(Scene({{-1, 1, 50}}).test(0, 3));
  EXPECT_FALSE(Scene({{1, 1, -50}}).test(0, 3));
}

TEST(Occluder, IsNeverAnEdgeOfTheFacet) {
  EXPECT_FALSE(Scene().test(0, 1));
  EXPECT_FALSE(Scene().test(2, 1));
}

TEST(Occluder, OfAnEdgeThroughTheFacetsPlaneIsOnlyItsNearerPart) {
  // The edge crosses the plane at x = -5, left of the facet, and rises over it.
  const std::optional<Occluder> rising = Scene({{-10, 2, -10}, {4, 2, 18}}).test(3, 4);
  ASSERT_TRUE(rising);
  EXPECT_TRUE(rising->crosses);
  EXPECT_NEAR(rising->segment[0].x, 0, 1e-9);
  // The edge passes down through the plane right of the facet, at x = 20, and then below the facet.
  EXPECT_FALSE(Scene({{-10, 2, -10}, {25, 2, 1.666f}}).test(3, 4));
}

TEST(ImagesOverlap, IsExactForNeighboursAndForFacetsOneBehindTheOther) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {10, 10, 3}, {1, 1, 50}, {2, 1, 50}, {1, 2, 50}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {4, 5, 6}};
  const Vec3 eye = kFrame.eye();
  EXPECT_FALSE(imagesOverlap(mesh, 0, 1, eye)) << "they share an edge";
  EXPECT_TRUE(imagesOverlap(mesh, 0, 2, eye));
  EXPECT_TRUE(imagesOverlap(mesh, 2, 0, eye));
  EXPECT_FALSE(imagesOverlap(mesh, 1, 2, eye));
  EXPECT_TRUE(imagesOverlap(mesh, 1, 1, eye));
}

TEST(CentreObstruction, NamesTheNearestFacetAndTheDistanceThatClearsAll) {
  // Two plates hang over a floor, at heights 20 … 30 and 60 … 70.
  const Mesh floor = shapes::translated(shapes::box({100, 100, 10}), {0, 0, -5});
  const Mesh plates = shapes::together(shapes::translated(shapes::box({9, 8, 10}), {1, 0, 25}),
                                       shapes::translated(shapes::box({9, 8, 10}), {1, 0, 65}));
  const Mesh mesh = shapes::together(floor, plates);
  const std::optional<CentreObstruction> obstruction =
      whatHidesCentre(mesh, kFrame, viewFrom(mesh, kFrame, allFacets(mesh)), allFacets(mesh));
  ASSERT_TRUE(obstruction);
  EXPECT_DOUBLE_EQ(obstruction->fromEyeMm, 30);
  EXPECT_DOUBLE_EQ(obstruction->clearDistanceMm, 20);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(mesh.corner(obstruction->triangle, k).z, 70);
  EXPECT_FALSE(whatHidesCentre(floor, kFrame, viewFrom(floor, kFrame, allFacets(floor)), allFacets(floor)));
}

}  // namespace
}  // namespace qrelief
