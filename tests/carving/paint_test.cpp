// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <set>

#include "carving/carving_oracle.h"
#include "mesh/ray_tree.h"
#include "support/shapes.h"
#include "verification/solidity.h"

namespace qrelief {
namespace {

using oracle::fieldOf;

const EmbedOptions kPaint{.paint = true};

double areaOf(const Mesh& mesh, std::size_t t) {
  return glm::length(glm::cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0))) / 2;
}

double areaOf(const Mesh& mesh) {
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) area += areaOf(mesh, t);
  return area;
}

std::set<std::array<float, 3>> placesOf(const Mesh& mesh) {
  std::set<std::array<float, 3>> places;
  for (const Vec3f p : mesh.positions) places.insert({p.x, p.y, p.z});
  return places;
}

/// Returns the greatest distance, along the rays, of a new vertex from the surface.
double farthestFrom(const Mesh& surface, const ProjectionFrame& frame, const Mesh& mesh) {
  const RayTree tree(surface);
  const auto before = placesOf(surface);
  double farthest = 0;
  for (const Vec3f p : mesh.positions) {
    if (before.contains({p.x, p.y, p.z})) continue;
    const Vec3 way = Vec3(p) - frame.eye();
    const auto hit = tree.firstHit(frame.eye(), glm::normalize(way), 0);
    farthest = std::max(farthest, hit ? std::abs(hit->distance - glm::length(way)) : 1e9);
  }
  return farthest;
}

TEST(Paint, OfOneSubmoduleOnAPlateIsItsSquare) {
  const Mesh mesh = shapes::plate({80, 80}, 10, 1, 1);
  const ProjectionFrame frame = makeFrame({11, -9, 0}, {0, 0, 1}, {0, 1, 0}, 250);
  const DepthField field = fieldOf(3, 3, [](int r, int c) { return r == 1 && c == 1 ? 0.01 : 0.0; });
  const auto result = oracle::carve(mesh, frame, field, kPaint);
  ASSERT_TRUE(result) << result.error().message;
  double painted = 0;
  for (const std::uint32_t t : result->painted) painted += areaOf(result->mesh, t);
  EXPECT_NEAR(painted, 1, 1e-4);  // outlines move by up to 0.01 mm, and here by less
  EXPECT_EQ(oracle::solidProblems(*result), "");
  EXPECT_NEAR(areaOf(result->mesh), areaOf(mesh), 1e-5 * areaOf(mesh));
}

TEST(Paint, ListsTrianglesOnlyForPaint) {
  const auto result =
      oracle::carve(shapes::plate({80, 80}, 10, 1, 1), makeFrame({11, -9, 0}, {0, 0, 1}, {0, 1, 0}, 250),
                    fieldOf(3, 3, [](int, int) { return 0.5; }));
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->painted.empty());
}

TEST(Paint, KeepsEveryVertexBitForBitAndEveryFacetPlaneUpToRounding) {
  std::mt19937 random(20261126);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const auto pick = [&](int n) { return static_cast<int>(unit() * n); };
  for (int k = 0; k < 24; ++k) {
    SCOPED_TRACE("case " + std::to_string(k));
    const int kind = k % 4;
    const Mesh mesh = kind == 0   ? shapes::plate({40, 40}, 10, 1 + pick(60), 1 + pick(60))
                      : kind == 1 ? shapes::icosphere(30, 1 + pick(4))
                      : kind == 2 ? shapes::bumpySphere(30, 0.3 + unit(), 1 + pick(3), 4)
                                  : shapes::torus(40, 20, 20 + pick(80), 20 + pick(60));
    const Vec3 centre = kind == 0 ? Vec3(unit(), unit(), 0) : kind <= 2 ? Vec3(30, 0, 0) : Vec3(60, 0, 0);
    const Vec3 outwards = kind == 0 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
    const ProjectionFrame frame =
        makeFrame(centre, outwards + (Vec3(unit(), unit(), unit()) - 0.5) * 0.3, {unit(), unit(), 1}, 250);
    const double share = 0.2 + 0.6 * unit();
    const DepthField field =
        fieldOf(5 * (1 + pick(4)), 4 + 8 * unit(), [&](int, int) { return unit() < share ? 0.01 : 0.0; });
    const auto result = oracle::carve(mesh, frame, field, kPaint);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(oracle::solidProblems(*result), "");
    EXPECT_TRUE(std::is_sorted(result->painted.begin(), result->painted.end()));
    ASSERT_FALSE(result->painted.empty());
    EXPECT_GE(result->painted.front(), result->keptTriangles);
    EXPECT_LT(result->painted.back(), result->mesh.triangles.size());

    const auto before = placesOf(mesh), after = placesOf(result->mesh);
    EXPECT_TRUE(std::includes(after.begin(), after.end(), before.begin(), before.end()));
    // 32-bit floats below 64 mm are 4 nm apart, so rounding moves a new vertex by at most 3.3 nm off its facet; along
    // the ray it is a little more.
    EXPECT_LT(farthestFrom(mesh, frame, result->mesh), 1e-5);
    EXPECT_NEAR(signedVolume(result->mesh), signedVolume(mesh), 2e-6 * field.symbolMm * field.symbolMm * 2);
    EXPECT_EQ(oracle::eulerCharacteristic(result->mesh), oracle::eulerCharacteristic(mesh));

    // The middle of every submodule lies in a triangle of its own colour.
    std::vector<char> isPainted(result->mesh.triangles.size(), 0);
    for (const std::uint32_t t : result->painted) isPainted[t] = 1;
    const RayTree tree(result->mesh);
    int wrong = 0;
    for (int row = 0; row < field.size; ++row)
      for (int column = 0; column < field.size; ++column) {
        const Vec2 middle = (field.corner(row, column) + field.corner(row + 1, column + 1)) / 2.0;
        const auto hit = tree.firstHit(frame.eye(), frame.rayDirection(middle), 0);
        wrong += !hit || (isPainted[hit->triangle] != 0) != (field.depth(row, column) > 0);
      }
    EXPECT_EQ(wrong, 0);
  }
}

}  // namespace
}  // namespace qrelief
