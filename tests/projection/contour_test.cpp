// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/contour.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "support/facets.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

const ProjectionFrame kFromAbove = makeFrame({0, 0, 10}, {0, 0, 1}, {0, 1, 0}, 250);

TEST(Contour, OfABoxSeenFaceOnAreTheFourEdgesOfThatFace) {
  const Mesh mesh = shapes::box({20, 20, 20});
  const EyeView view = viewFrom(mesh, kFromAbove, allFacets(mesh));
  EXPECT_EQ(std::count(view.facing.begin(), view.facing.end(), Facing::Front), 2);
  const std::vector<ContourEdge> edges =
      contourEdges(mesh, buildAdjacency(mesh.triangles), kFromAbove, view, allFacets(mesh));
  ASSERT_EQ(edges.size(), 4u);
  for (const ContourEdge& edge : edges) {
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(edge.ends[k].z, 10);
      EXPECT_DOUBLE_EQ(std::abs(edge.projected[k].x), 10);
      EXPECT_DOUBLE_EQ(std::abs(edge.projected[k].y), 10);
      EXPECT_EQ(Vec3(mesh.positions[edge.vertices[k]]), edge.ends[k]);
    }
  }
}

TEST(Contour, CountsFacetsSeenEdgeOnAsTurnedAway) {
  // The eye lies in the plane of the face x = 10.
  const Mesh mesh = shapes::box({20, 20, 20});
  const ProjectionFrame frame = makeFrame({10, 0, 10}, {0, 0, 1}, {0, 1, 0}, 250);
  const EyeView view = viewFrom(mesh, frame, allFacets(mesh));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 normal = triangleNormal(mesh, t);
    EXPECT_EQ(view.facing[t], normal.z > 0.5 ? Facing::Front : Facing::Away);
  }
}

TEST(Contour, ClipsEdgesBesideTheEye) {
  // A tall box stands next to the eye: its vertical edges pass from below to above the eye, at height 260.
  const Mesh mesh = shapes::translated(shapes::box({10, 10, 1000}), {50, 0, 0});
  const EyeView view = viewFrom(mesh, kFromAbove, allFacets(mesh));
  EXPECT_EQ(std::count(view.inFront.begin(), view.inFront.end(), 1), 4);
  EXPECT_EQ(std::count(view.facing.begin(), view.facing.end(), Facing::FrontOutOfReach), 2);
  std::size_t cut = 0;
  for (const ContourEdge& edge :
       contourEdges(mesh, buildAdjacency(mesh.triangles), kFromAbove, view, allFacets(mesh))) {
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_GT(kFromAbove.distanceAlongAxis(edge.ends[k]), 0);
      if (edge.vertices[k] == kNoVertex) {
        ++cut;
        EXPECT_NEAR(edge.ends[k].z, 260, 1e-6);
        EXPECT_EQ(edge.ends[k].x, 45);
      }
    }
  }
  EXPECT_EQ(cut, 2u);
}

TEST(Contour, IncludesOpenEdgesOfFacetsTurnedEitherWay) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const Triangle& t : {Triangle{0, 1, 2}, Triangle{0, 2, 1}}) {
    mesh.triangles = {t};
    const EyeView view = viewFrom(mesh, kFromAbove, allFacets(mesh));
    EXPECT_EQ(contourEdges(mesh, buildAdjacency(mesh.triangles), kFromAbove, view, allFacets(mesh)).size(), 3u);
  }
}

}  // namespace
}  // namespace qrelief
