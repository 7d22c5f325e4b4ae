// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/constrained_delaunay.h"

#include <gtest/gtest.h>

#include "messages/sentences.h"

namespace qrelief {
namespace {

using Pairs = std::vector<std::array<std::uint32_t, 2>>;

TEST(ConstrainedDelaunay, KeepsAConstraintThatDelaunayWouldNot) {
  // A flat kite: without the constraint, the triangulation takes its short diagonal 2-3.
  const std::vector<Vec2> points{{-5, 0}, {5, 0}, {0, -1}, {0, 1}};
  for (const bool constrained : {false, true}) {
    const auto result = triangulateConstrained(points, constrained ? Pairs{{0, 1}} : Pairs{});
    ASSERT_TRUE(result);
    ASSERT_EQ(result->triangles.size(), 2u);
    for (const Triangle& t : result->triangles) {
      const bool has0 = t[0] == 0 || t[1] == 0 || t[2] == 0, has1 = t[0] == 1 || t[1] == 1 || t[2] == 1;
      EXPECT_EQ(has0 && has1, constrained);
    }
  }
}

TEST(ConstrainedDelaunay, ReturnsCounterClockwiseTrianglesWithTheirNeighbours) {
  std::vector<Vec2> points;
  for (int k = 0; k < 60; ++k) points.emplace_back(k * 37 % 60 + 0.01 * k, k * 23 % 60);
  const auto result = triangulateConstrained(points, {});
  ASSERT_TRUE(result);
  for (std::size_t t = 0; t < result->triangles.size(); ++t) {
    const Triangle& c = result->triangles[t];
    EXPECT_GT(cross2(points[c[1]] - points[c[0]], points[c[2]] - points[c[0]]), 0);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = result->neighbours[t][k];
      if (other == kNoNeighbour) continue;
      const Triangle& o = result->triangles[other];
      int shared = 0;
      for (std::size_t m = 0; m < 3; ++m)
        if (o[m] == c[(k + 1) % 3] && o[(m + 1) % 3] == c[k]) shared += result->neighbours[other][m] == t;
      EXPECT_EQ(shared, 1);
    }
  }
}

TEST(ConstrainedDelaunay, RefusesCrossingConstraints) {
  const std::vector<Vec2> points{{-1, -1}, {1, 1}, {-1, 1}, {1, -1}};
  const auto result = triangulateConstrained(points, Pairs{{0, 1}, {2, 3}});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::Internal);
}

TEST(ConstrainedDelaunay, RefusesCoincidingPoints) {
  const std::vector<Vec2> points{{0, 0}, {1, 0}, {0, 1}, {1, 0}};
  const auto result = triangulateConstrained(points, {});
  ASSERT_FALSE(result);
  EXPECT_EQ(sentence(result.error().message), "1 point of the arrangement coincides with another");
}

}  // namespace
}  // namespace qrelief
