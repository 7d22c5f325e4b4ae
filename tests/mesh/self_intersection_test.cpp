// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/self_intersection.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

#include "base/random.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using Pairs = std::vector<TrianglePair>;

Mesh twoTriangles(std::vector<Vec3f> positions, Triangle a, Triangle b) { return Mesh{std::move(positions), {a, b}}; }

Pairs pairsOf(const Mesh& mesh) {
  const auto pairs = findCrossings(mesh);
  EXPECT_TRUE(pairs);
  return *pairs;
}

const Pairs kOnePair{{0, 1}};

TEST(FindCrossings, FindsNoneInSimpleSolids) {
  for (const Mesh& mesh : {shapes::box({1, 2, 3}), shapes::icosphere(5, 3), shapes::torus(10, 3, 24, 12),
                           shapes::plate({30, 20}, 4, 6, 5), shapes::cylinder(5, 9, 40)})
    EXPECT_TRUE(pairsOf(mesh).empty());
}

TEST(FindCrossings, FindsCrossingTriangles) {
  EXPECT_EQ(
      pairsOf(twoTriangles({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {5, 5, 1}}, {0, 1, 2}, {3, 4, 5})),
      kOnePair);
}

TEST(FindCrossings, CountsATouchAtAnUnsharedVertex) {
  EXPECT_EQ(
      pairsOf(twoTriangles({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {1, 1, 1}, {2, 2, 1}}, {0, 1, 2}, {3, 4, 5})),
      kOnePair);
}

TEST(FindCrossings, FindsNeighboursFoldedOntoEachOther) {
  EXPECT_EQ(pairsOf(twoTriangles({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 5, 0}}, {0, 1, 2}, {1, 0, 3})), kOnePair);
  // Pairs in one plane, but side by side; and pairs folded almost shut.
  EXPECT_TRUE(pairsOf(twoTriangles({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, -5, 0}}, {0, 1, 2}, {1, 0, 3})).empty());
  EXPECT_TRUE(pairsOf(twoTriangles({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 4, 1e-30f}}, {0, 1, 2}, {1, 0, 3})).empty());
}

TEST(FindCrossings, FindsTrianglesThatShareAVertexAndCrossBeyondIt) {
  EXPECT_EQ(pairsOf(twoTriangles({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}}, {0, 1, 2}, {0, 3, 4})),
            kOnePair);
  // A pair in one plane that overlaps in a wedge.
  EXPECT_EQ(pairsOf(twoTriangles({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {1, 3, 0}}, {0, 1, 2}, {0, 3, 4})),
            kOnePair);
  // A pair that touches at the shared vertex only.
  EXPECT_TRUE(
      pairsOf(twoTriangles({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {-1, -1, 0}, {-1, 0, 3}}, {0, 1, 2}, {0, 3, 4})).empty());
}

TEST(FindCrossings, FindsADuplicateTriangle) {
  EXPECT_EQ(pairsOf(twoTriangles({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {0, 1, 2}, {1, 0, 2})), kOnePair);
}

TEST(FindCrossings, IgnoresTrianglesWithoutArea) {
  EXPECT_TRUE(
      pairsOf(twoTriangles({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {1, 1, 3}}, {0, 1, 2}, {3, 4, 5}))
          .empty());
}

/// Returns two boxes, the second pushed through the first's upper face.
Mesh crossingBoxes() {
  return shapes::together(shapes::box({4, 4, 4}), shapes::translated(shapes::box({1, 1, 2}), {0.1, 0.2, 2}));
}

TEST(FindCrossings, FindsTheSamePairsFromTheSuspectsAlone) {
  const Mesh mesh = crossingBoxes();
  const Pairs all = pairsOf(mesh);
  ASSERT_FALSE(all.empty());
  std::vector<std::uint32_t> second;
  for (std::uint32_t t = 23; t >= 12; --t) second.push_back(t);
  EXPECT_EQ(*findCrossings(mesh, second), all);
  for (const auto& [a, b] : all) {
    EXPECT_LT(a, 12u);
    EXPECT_GE(b, 12u);
  }
  const std::vector<std::uint32_t> bystanders{0, 1};  // the first box's lower face
  EXPECT_TRUE(findCrossings(mesh, bystanders)->empty());
}

TEST(FindCrossings, FindsTheSameInALargeMeshAsInItsParts) {
  // The mesh is large enough to be split over several cores.
  const Mesh sphere = shapes::icosphere(10, 5);
  const Mesh mesh = shapes::together(sphere, shapes::translated(sphere, {18, 1, 2}));
  const Pairs all = *findCrossings(mesh, {}, 1'000'000);
  ASSERT_GT(all.size(), 100u);
  std::vector<std::uint32_t> even;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); t += 2) even.push_back(t);
  Pairs expected;
  for (const TrianglePair& pair : all)
    if (pair[0] % 2 == 0 || pair[1] % 2 == 0) expected.push_back(pair);
  EXPECT_EQ(*findCrossings(mesh, even, 1'000'000), expected);
  const Pairs first = *findCrossings(mesh, {}, 50);
  EXPECT_EQ(first.size(), 50u);
  EXPECT_EQ(first, *findCrossings(mesh, {}, 50));
  EXPECT_TRUE(std::includes(all.begin(), all.end(), first.begin(), first.end()));
}

/// Returns the crossing pairs, each tested as a mesh of two triangles.
Pairs pairsTestedAlone(const Mesh& mesh) {
  Pairs pairs;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::uint32_t u = t + 1; u < mesh.triangles.size(); ++u)
      if (!pairsOf({mesh.positions, {mesh.triangles[t], mesh.triangles[u]}}).empty()) pairs.push_back({t, u});
  return pairs;
}

TEST(FindCrossings, FindsInACrumpledSurfaceWhatPairsTestedAloneShow) {
  Random random(7);
  for (const double crumple : {0.2, 0.6, 2.0})
    for (const double grid : {0.0, 0.5}) {  // on a grid many corners lie exactly on other triangles
      Mesh mesh = shapes::icosphere(5, 1);
      for (Vec3f& p : mesh.positions)
        for (int axis = 0; axis < 3; ++axis) {
          const double moved = static_cast<double>(p[axis]) + random.uniform(-crumple, crumple);
          p[axis] = static_cast<float>(grid > 0 ? grid * std::round(moved / grid) : moved);
        }
      EXPECT_EQ(findCrossings(mesh, {}, 1'000'000).value(), pairsTestedAlone(mesh)) << crumple << " " << grid;
    }
}

TEST(FindCrossings, StopsAtTheLimit) { EXPECT_EQ(findCrossings(crossingBoxes(), {}, 3)->size(), 3u); }

/// Returns two cones on one base, with n triangles each around their apexes.
Mesh bicone(std::uint32_t n) {
  Mesh mesh;
  mesh.positions = {{0, 0, 10}, {0, 0, -10}};
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    mesh.positions.emplace_back(50 * std::cos(angle), 50 * std::sin(angle), 0);
    const std::uint32_t a = 2 + i, b = 2 + (i + 1) % n;
    mesh.triangles.insert(mesh.triangles.end(), {{0, a, b}, {1, b, a}});
  }
  return mesh;
}

TEST(FindCrossings, GivesUpIfAllTrianglesShareOneVertex) {
  const auto crossings = findCrossings(bicone(2000), {}, 1000, 1'000'000);
  ASSERT_FALSE(crossings);
  EXPECT_EQ(crossings.error().kind, ErrorKind::NoSolution);
  EXPECT_EQ(crossings.error().message.code, "crossings-too-crowded");
  std::vector<std::uint32_t> suspects(1000);
  std::iota(suspects.begin(), suspects.end(), 0u);
  EXPECT_FALSE(findCrossings(bicone(2000), suspects, 1000, 100'000));
}

TEST(FindCrossings, ChecksAllPairsOfAFineCone) {
  const auto crossings = findCrossings(bicone(2000));
  ASSERT_TRUE(crossings);
  EXPECT_TRUE(crossings->empty());
}

TEST(FindCrossings, DecidesExactlyOnAGridOfNearlyTouchingPoints) {
  // A vertex moves by single float steps across the plane of a slanted triangle, x + y + z = 3. The triangles cross on
  // one side of it and do not on the other.
  for (int step = -8; step <= 8; ++step) {
    float z = 1;
    for (int i = 0; i < std::abs(step); ++i) z = std::nextafter(z, step > 0 ? 2.0f : 0.0f);
    const Mesh mesh =
        twoTriangles({{3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {1, 1, z}, {3, 3, 3}, {3, 4, 3}}, {0, 1, 2}, {3, 4, 5});
    EXPECT_EQ(pairsOf(mesh).size(), step <= 0 ? 1u : 0u) << step;
  }
}

TEST(FindSelfIntersections, IgnoresShellsThatOverlap) {
  EXPECT_FALSE(findCrossings(crossingBoxes())->empty());
  EXPECT_TRUE(findSelfIntersections(crossingBoxes())->empty());
}

TEST(FindSelfIntersections, FindsThePairsWithinAShellBesideAnother) {
  const Mesh tangled = shapes::tangledSphere();
  const Mesh mesh = shapes::together(tangled, shapes::translated(shapes::box({4, 4, 4}), {0, 0, 9}));
  EXPECT_EQ(*findSelfIntersections(mesh), *findCrossings(tangled));
}

}  // namespace
}  // namespace qrelief
