// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/triangle_separation.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "base/random.h"
#include "mesh/box_tree.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

/// Returns a point with whole coordinates, so that sums and small multiples are exact. Half the points have z = 0.
Vec3 wholePoint(Random& random) {
  const auto coordinate = [&] { return static_cast<double>(random.below(41)) - 20; };
  const bool flat = random.below(2) == 0;
  return {coordinate(), coordinate(), flat ? 0 : coordinate()};
}

/// Scales and moves corners like a real model, by powers of two and whole numbers, so exact results stay exact.
Corners placed(const Corners& corners, double scale) {
  Corners result = corners;
  for (Vec3& p : result) p = (p + Vec3(1000, -300, 77)) * scale;
  return result;
}

TEST(CertainlyApart, NeverSeparatesTrianglesWithACommonPoint) {
  Random random(1);
  for (int i = 0; i < 200'000; ++i) {
    const Vec3 common = wholePoint(random);  // both triangles' centroid
    const auto around = [&] {
      const Vec3 u = wholePoint(random);
      const Vec3 v = wholePoint(random);
      return Corners{u, v, common * 3.0 - u - v};
    };
    const double scale = i % 3 == 0 ? 0x1p-30 : i % 3 == 1 ? 1 : 0x1p40;
    ASSERT_FALSE(certainlySeparate(placed(around(), scale), placed(around(), scale))) << i;
  }
}

TEST(CertainlyApart, NeverSeparatesTrianglesThatTouchAtAPoint) {
  Random random(2);
  for (int i = 0; i < 200'000; ++i) {
    const Corners a{wholePoint(random), wholePoint(random), wholePoint(random)};
    const Vec3 onEdge = (a[0] + a[1]) * 0.5;
    ASSERT_FALSE(certainlySeparate(a, {onEdge, wholePoint(random), wholePoint(random)})) << i;
  }
}

TEST(CertainlyApartButForCorner, NeverSeparatesNeighboursThatMeetElsewhereToo) {
  Random random(3);
  for (int i = 0; i < 200'000; ++i) {
    const Vec3 corner = wholePoint(random);
    const Vec3 u = wholePoint(random);
    const Vec3 v = wholePoint(random);
    const Vec3 w = wholePoint(random);  // the edges opposite the corner share their midpoint
    const Corners a{corner, u, v};
    const Corners b{corner, w, u + v - w};
    ASSERT_FALSE(certainlySeparateButForCorner(placed(a, 1), placed(b, 1))) << i;
  }
}

TEST(CertainlyApartButForEdge, NeverSeparatesFoldedTriangles) {
  Random random(4);
  for (int i = 0; i < 200'000; ++i) {
    const Vec3 p = wholePoint(random);
    const Vec3 q = wholePoint(random);
    const Vec3 r = wholePoint(random);
    const double along = static_cast<double>(random.below(5)) - 2;
    const double across = static_cast<double>(random.below(3)) + 1;
    const Corners b{p, q, p + (q - p) * along + (r - p) * across};
    ASSERT_FALSE(certainlySeparateButForEdge(placed({p, q, r}, 1), placed(b, 1))) << i;
  }
}

TEST(CertainlyApart, DetectsAGapAboveBesideAndBetweenEdges) {
  const Corners a{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
  EXPECT_TRUE(certainlySeparate(a, {Vec3(0, 0, 0.001), Vec3(4, 0, 0.001), Vec3(0, 4, 0.001)}));
  EXPECT_TRUE(certainlySeparate(a, {Vec3(4, 4, 0), Vec3(2.001, 2, 0), Vec3(2.001, 6, 0)}));
  EXPECT_TRUE(certainlySeparate(a, {Vec3(1, -0.001, -1), Vec3(2, -0.001, -1), Vec3(1, -0.001, 9)}));
}

/// Exact predicates must remain the exception, or the search becomes slow.
TEST(CertainlyApart, SeparatesNearlyAllNeighboursOfASurface) {
  for (const Mesh& mesh : {shapes::bumpySphere(10, 2, 4, 3), shapes::torus(10, 3, 40, 20)}) {
    std::size_t pairs = 0;
    std::size_t settled = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::size_t u = 0; u < t; ++u) {
        if (!boxOfTriangle(mesh, mesh.triangles[t]).overlaps(boxOfTriangle(mesh, mesh.triangles[u]))) continue;
        Triangle a = mesh.triangles[t];
        Triangle b = mesh.triangles[u];
        const auto inBoth = [&](std::uint32_t v) {
          return std::find(a.begin(), a.end(), v) != a.end() && std::find(b.begin(), b.end(), v) != b.end();
        };
        const auto shared = std::count_if(a.begin(), a.end(), inBoth);
        for (Triangle* triangle : {&a, &b})
          std::sort(triangle->begin(), triangle->end(), [&](std::uint32_t v, std::uint32_t w) {
            return std::pair(!inBoth(v), v) < std::pair(!inBoth(w), w);
          });
        const auto corners = [&](const Triangle& triangle) {
          return Corners{Vec3(mesh.positions[triangle[0]]), Vec3(mesh.positions[triangle[1]]),
                         Vec3(mesh.positions[triangle[2]])};
        };
        ++pairs;
        settled += shared == 0   ? certainlySeparate(corners(a), corners(b))
                   : shared == 1 ? certainlySeparateButForCorner(corners(a), corners(b))
                                 : certainlySeparateButForEdge(corners(a), corners(b));
      }
    EXPECT_GE(pairs, 6 * mesh.triangles.size());  // per triangle 3/2 over edges and about 9/2 at corners, at least
    EXPECT_GE(static_cast<double>(settled), 0.995 * static_cast<double>(pairs));
  }
}

}  // namespace
}  // namespace qrelief
