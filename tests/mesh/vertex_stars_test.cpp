// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/vertex_stars.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

#include "support/shapes.h"

namespace qrelief {
namespace {

std::size_t countOf(const std::vector<std::uint8_t>& stars) {
  return static_cast<std::size_t>(std::accumulate(stars.begin(), stars.end(), 0));
}

TEST(SimpleStars, AreAllVerticesOfSmoothSolids) {
  for (const Mesh& mesh : {shapes::icosphere(5, 3), shapes::torus(10, 3, 24, 12), shapes::bumpySphere(20, 2, 4, 4),
                           shapes::box({1, 2, 3}), shapes::tetrahedron(2)})
    EXPECT_EQ(countOf(simpleStars(mesh)), mesh.positions.size());
}

TEST(SimpleStars, AreThoseAskedAboutOnly) {
  const Mesh mesh = shapes::icosphere(5, 2);
  const std::vector<std::uint32_t> asked{4};
  const auto stars = simpleStars(mesh, asked);
  EXPECT_EQ(countOf(stars), 3u);
  for (const std::uint32_t v : mesh.triangles[4]) EXPECT_EQ(stars[v], 1);
}

/// Returns a fan of triangles round vertex 0, which lies at the origin.
Mesh fan(std::vector<Vec3f> rim) {
  Mesh mesh{{Vec3f(0)}, {}};
  const auto n = static_cast<std::uint32_t>(rim.size());
  mesh.positions.insert(mesh.positions.end(), rim.begin(), rim.end());
  for (std::uint32_t k = 0; k < n; ++k) mesh.triangles.push_back({0, 1 + k, 1 + (k + 1) % n});
  return mesh;
}

TEST(SimpleStars, AreNotVerticesWhoseTrianglesMayMeet) {
  const Mesh flat = fan({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}});
  EXPECT_EQ(simpleStars(flat)[0], 1);
  EXPECT_EQ(simpleStars(flat)[1], 0);  // on the border

  EXPECT_EQ(simpleStars(fan({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0.5f, 0.5f, 0}}))[0], 0);  // folded back
  // Twice round the vertex: every triangle is anticlockwise.
  EXPECT_EQ(simpleStars(fan({{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, 0, 1}, {-1, 1, 1}, {-1, -1, 1}}))[0], 0);
  EXPECT_EQ(simpleStars(fan({{1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {-1, -1, 0}}))[0], 0);  // a triangle without area

  Mesh twice = flat;
  twice.triangles.push_back(twice.triangles[0]);
  EXPECT_EQ(simpleStars(twice)[0], 0);

  Mesh cone = fan([] {
    std::vector<Vec3f> rim;
    for (int k = 0; k < 100; ++k) rim.emplace_back(Vec3(std::cos(0.0628 * k), std::sin(0.0628 * k), 0));
    return rim;
  }());
  EXPECT_EQ(simpleStars(cone)[0], 0);  // too many triangles to look at
}

}  // namespace
}  // namespace qrelief
