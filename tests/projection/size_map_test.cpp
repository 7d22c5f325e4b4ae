// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/size_map.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>

#include "base/random.h"
#include "projection/silhouette.h"
#include "projection/size.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

SizeMap mapOf(const Mesh& mesh, const SizeMapOptions& options) {
  return makeSizeMap(mesh, vertexNormals(mesh), options);
}

double largest(const SizeMap& map) {
  return static_cast<double>(*std::max_element(map.sizeMm.begin(), map.sizeMm.end()));
}

TEST(LatticeDirection, LeavesNoGapsOnTheSphere) {
  // Equal caps that cover a sphere have at least 4π/n each, i.e. a radius of 7.4° for 240; the lattice needs half as
  // much again.
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const double z = random.uniform(-1, 1), angle = random.uniform(0, 2 * std::numbers::pi);
    const Vec3 any(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z);
    double nearest = -1;
    for (int k = 0; k < 240; ++k) nearest = std::max(nearest, glm::dot(any, latticeDirection(k, 240)));
    EXPECT_GT(nearest, std::cos(11 * kDegree));
  }
}

TEST(SizeMap, HasTheSameSizeAtEveryPointOfASphere) {
  const double radius = 40, eye = 250 + radius;
  const SizeMap map = mapOf(shapes::icosphere(radius, 5), {.minMm = 30, .views = 1000});
  // The disc ends where the surface is at 65° to the line of sight: polar angle θ and eye angle φ, θ + φ = 65°.
  double theta = 0, phi = 0;
  while (theta + phi < SizeMapSearch::kMaxTiltDeg * kDegree) {
    theta += 1e-5;
    phi = std::atan(radius * std::sin(theta) / (eye - radius * std::cos(theta)));
  }
  const double expected = std::numbers::sqrt2 * std::tan(phi) * 250;
  // The nearest of 1000 directions may be 5° off: cos(65° - 5°)… Then the near rim is nearer by up to r·(sin 65°
  // - sin 60°) or more, since the eye sees the circle from off its axis.
  for (std::size_t v = 0; v < map.sizeMm.size(); ++v) {
    EXPECT_LT(map.sizeMm[v], expected * 1.02);
    EXPECT_GT(map.sizeMm[v], expected * 0.86);
    // A texel of 1.9 mm is 2.7° of the sphere, and the size is accurate to two.
    EXPECT_GT(glm::dot(map.direction[v], map.normals[v]), std::cos((5 + 2 * 2.7) * kDegree));
  }
}

TEST(SizeMap, IsLargestInTheMiddleOfACubesFaces) {
  const double edge = 60;
  const SizeMap map = mapOf(shapes::box({edge, edge, edge}), {.minMm = 30, .views = 1000});
  // The size fits at every rotation: the disc has a radius of half the edge, so the square is edge/√2, give or take a
  // texel.
  const double expected = edge / std::numbers::sqrt2;
  EXPECT_NEAR(largest(map), expected, 0.05 * expected);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Vec3 middle(0);
      middle[axis] = side * edge / 2;
      std::size_t nearest = 0;
      for (std::size_t v = 0; v < map.sizeMm.size(); ++v)
        if (glm::distance(Vec3(map.mesh.positions[v]), middle) <
            glm::distance(Vec3(map.mesh.positions[nearest]), middle))
          nearest = v;
      EXPECT_GT(map.sizeMm[nearest], 0.92 * expected) << axis << side;
    }
  }
}

TEST(SizeMap, OffersNoCentreOnTheEdgesAndCornersOfACube) {
  const SizeMap map = mapOf(shapes::box({60, 60, 60}), {.minMm = 30});
  for (std::size_t v = 0; v < map.sizeMm.size(); ++v) {
    const Vec3 p = glm::abs(Vec3(map.mesh.positions[v]));
    const bool isOnEdge = (p.x == 30) + (p.y == 30) + (p.z == 30) > 1;
    EXPECT_FALSE(isOnEdge && map.sizeMm[v] > 0) << p.x << ' ' << p.y << ' ' << p.z;
  }
}

TEST(SizeMap, DiscardsViewsOfARodWithASilhouetteSmallerThanTheSquare) {
  const SizeMap map = mapOf(shapes::cylinder(2, 100, 24), {.minMm = 26});
  EXPECT_EQ(map.viewsDropped, 240);
  EXPECT_EQ(largest(map), 0);
}

TEST(SizeMap, LimitsTheSizeOnARodToItsThickness) {
  const SizeMap map = mapOf(shapes::cylinder(4, 100, 48), {.minMm = 8});
  EXPECT_LT(largest(map), std::numbers::sqrt2 * 4 + 0.3);
}

TEST(SizeMap, PrefersTheBallsOfADumbbellToItsBar) {
  const Mesh ball = shapes::icosphere(30, 4);
  const Mesh balls = shapes::together(shapes::translated(ball, {0, 0, 70}), shapes::translated(ball, {0, 0, -70}));
  const SizeMap map = mapOf(shapes::together(balls, shapes::cylinder(5, 78, 32)), {.minMm = 10});
  double onBar = 0;
  for (std::size_t v = 0; v < map.sizeMm.size(); ++v)
    if (std::abs(map.mesh.positions[v].z) < 39.5f) onBar = std::max<double>(onBar, map.sizeMm[v]);
  EXPECT_LT(onBar, std::numbers::sqrt2 * 5 + 1);
  EXPECT_GT(onBar, 4);
  EXPECT_GT(largest(map), 30);
}

/// Returns the size that the exact silhouette allows around a vertex, seen from the map's eye.
double exactSize(const Mesh& model, const SizeMap& map, std::uint32_t vertex, Vec3 centre, double eyeFromCentre) {
  const Vec3 p(map.mesh.positions[vertex]);
  const Vec3 d(map.direction[vertex]);
  const double along = glm::dot(p - centre, d);
  const double distance =
      -along + std::sqrt(along * along - glm::dot(p - centre, p - centre) + eyeFromCentre * eyeFromCentre);
  const ProjectionFrame frame = makeFrame(p, d, {0, 0, 1}, distance);
  const Adjacency adjacency = buildAdjacency(model.triangles);
  for (std::uint32_t t = 0; t < model.triangles.size(); ++t) {
    const Triangle& corners = model.triangles[t];
    if (std::find(corners.begin(), corners.end(), vertex) == corners.end()) continue;
    const auto patch = findSilhouette(model, adjacency, frame, t, 1000);
    if (patch) return freeSize(patch->silhouette);
  }
  return 0;
}

TEST(SizeMap, NeverPromisesMuchMoreThanTheExactSilhouette) {
  for (const Mesh& mesh : {shapes::bumpySphere(40, 4, 4, 4), shapes::torus(30, 14, 64, 32)}) {
    const SizeMap map = mapOf(mesh, {.minMm = 20});
    ASSERT_TRUE(std::equal(mesh.positions.begin(), mesh.positions.end(), map.mesh.positions.begin()));
    const Box3 box = boundingBox(mesh);
    double radius = 0;
    for (const Vec3f& p : mesh.positions) radius = std::max(radius, glm::distance(Vec3(p), box.centre()));
    int compared = 0;
    for (std::uint32_t v = 0; v < mesh.positions.size(); v += 23) {
      if (map.sizeMm[v] == 0) continue;
      const double exact = exactSize(mesh, map, v, box.centre(), radius + 250);
      EXPECT_LT(map.sizeMm[v], exact + 2.5 * 20 / 32 + 0.03 * exact) << v;
      ++compared;
    }
    EXPECT_GT(compared, 40);
  }
}

TEST(SizeMap, ACoarserMeshHardlyChangesIt) {
  const Mesh mesh = shapes::bumpySphere(50, 2, 5, 6);
  const SizeMap fine = mapOf(mesh, {.minMm = 30, .views = 200, .facets = 100000});
  const SizeMap coarse = mapOf(mesh, {.minMm = 30, .views = 200, .facets = 10000});
  EXPECT_LT(coarse.mesh.triangles.size(), 20000u);
  ASSERT_EQ(coarse.vertexOf.size(), mesh.positions.size());
  double difference = 0, sum = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const double exact = fine.sizeMm[fine.vertexOf[v]];
    difference += std::abs(exact - static_cast<double>(coarse.sizeMm[coarse.vertexOf[v]]));
    sum += exact;
  }
  EXPECT_LT(difference / sum, 0.15);
}

TEST(SizeMap, UsesASingleDirectionOnRequest) {
  const SizeMap map = mapOf(shapes::icosphere(40, 4), {.minMm = 20, .onlyFrom = Vec3(0, 0, 2)});
  for (std::size_t v = 0; v < map.sizeMm.size(); ++v)
    EXPECT_TRUE(map.sizeMm[v] == 0 || map.direction[v].z > std::cos(12 * kDegree));
  EXPECT_GT(largest(map), 40);
}

TEST(SizeMap, OfSeveralViewsHasTheSquaresOfEach) {
  const Mesh mesh = shapes::bumpySphere(40, 3, 4, 4);
  constexpr int kViews = 7;  // not a multiple of the views of a step
  const SizeMap all = mapOf(mesh, {.minMm = 20, .views = kViews});
  std::vector<SizeMap> single;
  for (int view = 0; view < kViews; ++view)
    single.push_back(mapOf(mesh, {.minMm = 20, .onlyFrom = latticeDirection(view, kViews)}));
  for (std::size_t v = 0; v < all.sizeMm.size(); ++v) {
    const bool isInOne = std::any_of(single.begin(), single.end(), [&](const SizeMap& one) {
      return one.sizeMm[v] == all.sizeMm[v] && one.direction[v] == all.direction[v];
    });
    const bool isInNone =
        std::all_of(single.begin(), single.end(), [&](const SizeMap& one) { return one.sizeMm[v] == 0; });
    EXPECT_TRUE(isInOne) << v;
    EXPECT_EQ(all.sizeMm[v] == 0, isInNone) << v;
  }
}

TEST(SizeMap, IsDeterministic) {
  const Mesh mesh = shapes::bumpySphere(40, 3, 4, 4);
  const SizeMap first = mapOf(mesh, {.minMm = 20});
  const SizeMap second = mapOf(mesh, {.minMm = 20});
  EXPECT_EQ(first.sizeMm, second.sizeMm);
  EXPECT_EQ(first.direction, second.direction);
}

}  // namespace
}  // namespace qrelief
