// SPDX-License-Identifier: GPL-3.0-or-later
// Surface mode "resampled" of carving/embed.h.
#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <set>

#include "carving/carving_oracle.h"
#include "carving/embed.h"
#include "math/tolerance.h"
#include "messages/sentences.h"
#include "support/brute_force.h"
#include "support/shapes.h"
#include "verification/solidity.h"

namespace qrelief {
namespace {

using oracle::fieldOf;

const EmbedOptions kResampled{.surface = SurfaceMode::Resampled};

ProjectionFrame aboveOrigin(double z = 0) { return makeFrame({0, 0, z}, {0, 0, 1}, {0, 1, 0}, 250); }

double maximumNorm(Vec2 p) { return std::max(std::abs(p.x), std::abs(p.y)); }

/// Returns true if a triangle's image has a point in the square |u|, |v| ≤ half, i.e. if clipping leaves some of it.
bool meetsSquare(std::vector<Vec2> polygon, double half) {
  for (const Vec2 outward : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
    std::vector<Vec2> rest;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec2 p = polygon[k], q = polygon[(k + 1) % polygon.size()];
      const double from = glm::dot(p, outward) - half, to = glm::dot(q, outward) - half;
      if (from <= 0) rest.push_back(p);
      if ((from < 0 && to > 0) || (from > 0 && to < 0)) rest.push_back(p + (q - p) * (from / (from - to)));
    }
    polygon = rest;
  }
  return !polygon.empty();
}

TEST(Resampled, ReplacesTheFacetsOfADensePlateByTheGrid) {
  // 160 × 160 squares on 20 mm put some 5000 facets into the 10 mm square; its grid has 2·5² cells.
  const Mesh mesh = shapes::plate({20, 20}, 10, 160, 160);
  const ProjectionFrame frame = makeFrame({0.013, 0.027, 0}, {0, 0, 1}, {0.2, 1, 0}, 250);
  const DepthField field = fieldOf(5, 10, [](int r, int c) { return r == 2 && c == 2 ? 0.5 : 0.0; });
  const auto result = oracle::carve(mesh, frame, field, kResampled);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(oracle::solidProblems(*result), "");
  std::size_t within = 0;
  for (const Vec3f& p : result->mesh.positions) {
    const Vec2 at = frame.project(Vec3(p));
    if (p.z < -5 || maximumNorm(at) > 4.9) continue;
    ++within;
    const double offGrid = maximumNorm((at - 1.0) / 2.0 - glm::round((at - 1.0) / 2.0)) * 2;
    EXPECT_LT(offGrid, 1e-5) << at.x << ", " << at.y;
  }
  EXPECT_EQ(within, 16u + 4u);  // the inner corners and the floor's corners
}

TEST(Resampled, RemovesTheVolumeOfThePocketsFromAPlate) {
  const Mesh mesh = shapes::plate({47, 43}, 10, 3, 2);
  const ProjectionFrame frame = makeFrame({1.3, 0.7, 0}, {0, 0, 1}, {0.3, 1, 0}, 250);
  // The border stays uncarved because its nodes may move. No diagonal neighbours are carved because the outlines keep
  // them apart.
  const DepthField field = fieldOf(
      25, 25, [](int r, int c) { return r > 0 && r < 24 && c > 0 && c < 24 && r % 2 == 0 ? 0.1 + 0.03 * c : 0.0; });
  const auto result = oracle::carve(mesh, frame, field, kResampled);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(oracle::solidProblems(*result), "");
  const double expected =
      oracle::pocketVolume(frame, field, [&](Vec2 p) { return glm::length(frame.onPlane(p) - frame.eye()); });
  EXPECT_NEAR(signedVolume(mesh) - signedVolume(result->mesh), expected, 2e-5 * expected);
}

TEST(Resampled, PutsTheCornersOfTheGridOnTheSurface) {
  const Mesh mesh = shapes::bumpySphere(30, 1, 3, 5);
  const ProjectionFrame frame = makeFrame({0, 0, 30}, {0.2, 0.1, 1}, {0, 1, 0}, 250);
  const DepthField field = fieldOf(10, 9, [](int r, int c) { return r == 4 && c == 4 ? 0.3 : 0.0; });
  const auto result = oracle::carve(mesh, frame, field, kResampled);
  ASSERT_TRUE(result) << result.error().message;
  for (int row = 1; row < field.size; ++row)
    for (int column = 1; column < field.size; ++column) {
      const Vec3 ray = frame.rayDirection(field.corner(row, column));
      const Vec3 expected = frame.eye() + ray * brute_force::castRay(mesh, frame.eye(), ray).distance;
      double nearest = 1e9;
      for (const Vec3f& p : result->mesh.positions) nearest = std::min(nearest, glm::distance(Vec3(p), expected));
      EXPECT_LT(nearest, 5e-6) << row << ", " << column;
    }
}

TEST(Resampled, KeepsExactlyTheFacetsOutsideTheSquareBitForBit) {
  const Mesh mesh = shapes::bumpySphere(30, 0.5, 3, 5);
  const ProjectionFrame frame = makeFrame({0, 0, 30}, {0.2, 0.1, 1}, {0, 1, 0}, 250);
  const DepthField field = fieldOf(15, 12, [](int r, int c) { return r % 5 == 0 || c % 5 == 0 ? 0.0 : 0.3; });
  const auto result = oracle::carve(mesh, frame, field, kResampled);
  ASSERT_TRUE(result) << result.error().message;
  std::size_t next = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto sameCorners = [&](std::size_t kept) {
      for (int k = 0; k < 3; ++k)
        if (mesh.corner(t, k) != result->mesh.corner(kept, k)) return false;
      return true;
    };
    const bool kept = next < result->keptTriangles && sameCorners(next);
    next += kept;
    const std::vector<Vec2> image{frame.project(mesh.corner(t, 0)), frame.project(mesh.corner(t, 1)),
                                  frame.project(mesh.corner(t, 2))};
    const bool front = cross2(image[1] - image[0], image[2] - image[0]) > 0;
    const double slack = EmbedOptions{}.snapMm;
    const bool beside = !front || !meetsSquare(image, field.symbolMm / 2 + slack);
    const bool within = front && meetsSquare(image, field.symbolMm / 2 - slack);
    EXPECT_TRUE(kept || !beside) << t;
    EXPECT_TRUE(!kept || !within) << t;
  }
  EXPECT_EQ(next, result->keptTriangles);
}

TEST(Resampled, RefusesAHoleOfThePatchUnderAnUncarvedPartOfTheSquare) {
  const Mesh mesh = shapes::plate({20, 20}, 10, 40, 40);
  const std::vector<std::uint32_t> patch = oracle::frontPatchWithHole(mesh, aboveOrigin());
  const DepthField corner = fieldOf(5, 8, [](int r, int c) { return r == 0 && c == 0 ? 0.3 : 0.0; });
  EXPECT_TRUE(embedDepthField(mesh, aboveOrigin(), patch, corner));
  const auto result = embedDepthField(mesh, aboveOrigin(), patch, corner, kResampled);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::NoSolution);
  EXPECT_THAT(sentence(result.error().message), testing::HasSubstr("extends beyond the visible surface"));
}

TEST(Resampled, RefusesASquareThatLeavesThePlateEvenIfNoPocketDoes) {
  const Mesh mesh = shapes::plate({20, 20}, 10, 3, 3);
  const DepthField middle = fieldOf(5, 10, [](int r, int c) { return r == 2 && c == 2 ? 0.3 : 0.0; });
  const ProjectionFrame frame = makeFrame({7, 0, 0}, {0, 0, 1}, {0, 1, 0}, 250);
  EXPECT_TRUE(oracle::carve(mesh, frame, middle));
  const auto result = oracle::carve(mesh, frame, middle, kResampled);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::NoSolution);
}

TEST(Resampled, HandlesAPlateWhoseMeshIsTheSubmoduleGrid) {
  const Mesh mesh = shapes::plate({12, 12}, 10, 24, 24);
  const DepthField field = fieldOf(20, 10, [](int r, int c) { return 0.01 * ((5 * r + 3 * c) % 40); });
  const auto result = oracle::carve(mesh, aboveOrigin(), field, kResampled);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(oracle::solidProblems(*result), "");
}

/// As for preserved surfaces (embed_test.cpp), except that the surface between grid lines lies off the model by its
/// bulge.
TEST(Resampled, MakesASolidOfTheRightDepthForAnyFieldAndShape) {
  std::mt19937 random(20221122);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const auto pick = [&](int n) { return static_cast<int>(unit() * n); };
  for (int k = 0; k < 60; ++k) {
    SCOPED_TRACE("case " + std::to_string(k));
    const Vec3 offset = (Vec3(unit(), unit(), unit()) - 0.5) * (k % 4 == 0 ? 300.0 : 20.0);
    const int kind = k % 4;
    Mesh mesh = kind == 0   ? shapes::plate({30, 30}, 10, 1 + pick(60), 1 + pick(60))
                : kind == 1 ? shapes::icosphere(30, 4 + pick(3))
                : kind == 2 ? shapes::cylinder(30, 60, 100 + pick(200))
                            : shapes::torus(40, 20, 120 + pick(100), 80 + pick(80));
    mesh = shapes::translated(std::move(mesh), offset);
    const Vec3 centre = kind == 0   ? Vec3(unit(), unit(), 0)
                        : kind == 3 ? Vec3(60, 0, 0)
                                    : Vec3(kind == 1 ? 30 : 30 * std::cos(0.001), 0, kind == 2 ? 5 * unit() : 0.0);
    const Vec3 outwards = kind == 0 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
    const ProjectionFrame frame =
        makeFrame(centre + offset, outwards + (Vec3(unit(), unit(), unit()) - 0.5) * 0.3, {unit(), unit(), 1}, 250);
    const double share = unit();
    const DepthField field = fieldOf(5 * (2 + pick(4)), 4 + 8 * unit(),
                                     [&](int, int) { return unit() < share ? kDepthQuantumMm * (1 + pick(40)) : 0.0; });
    const auto result = oracle::carve(mesh, frame, field, kResampled);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(oracle::solidProblems(*result), "");
    EXPECT_EQ(oracle::eulerCharacteristic(result->mesh), oracle::eulerCharacteristic(mesh));
    // The sag of a chord as long as a cell's diagonal on a radius of 20 mm, plus the facets' own flatness.
    const double sag = field.submoduleMm() * field.submoduleMm() * 2 / (8 * 20);
    EXPECT_LT(oracle::largestDepthError(mesh, result->mesh, frame, field, 0.2 * field.submoduleMm(), 2),
              kind == 0 ? 5e-4 : 2 * sag + 0.02);
  }
}

}  // namespace
}  // namespace qrelief
