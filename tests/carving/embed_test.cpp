// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/embed.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>

#include "carving/carving_oracle.h"
#include "math/tolerance.h"
#include "mesh/topology.h"
#include "message_codes/place.h"
#include "messages/sentences.h"
#include "support/shapes.h"
#include "verification/solidity.h"

namespace qrelief {
namespace {

using oracle::carve;
using oracle::fieldOf;

const Vec3 kUp(0, 0, 1);
const Vec3 kTowardsZ(0, 0, 1);

ProjectionFrame aboveOrigin(double z = 0) { return makeFrame({0, 0, z}, kTowardsZ, {0, 1, 0}, 250); }

/// Returns a plate of few large facets whose edges cross the submodules at no special point.
Mesh coarsePlate() { return shapes::plate({47, 43}, 10, 3, 2); }

double flatDistance(const ProjectionFrame& frame, Vec2 p) { return glm::length(frame.onPlane(p) - frame.eye()); }

double volumeLost(const Mesh& before, const EmbedResult& after) {
  return signedVolume(before) - signedVolume(after.mesh);
}

using CornerTriple = std::array<std::array<float, 3>, 3>;

CornerTriple cornersOf(const Mesh& mesh, std::size_t t) {
  CornerTriple corners{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3f p = mesh.positions[mesh.triangles[t][k]];
    corners[k] = {p.x, p.y, p.z};
  }
  return corners;
}

TEST(Embed, LeavesTheMeshUnchangedWithoutCarving) {
  const Mesh mesh = coarsePlate();
  const auto result = carve(mesh, aboveOrigin(), fieldOf(5, 10, [](int, int) { return 0.0; }));
  ASSERT_TRUE(result);
  EXPECT_EQ(result->mesh.triangles, mesh.triangles);
  EXPECT_EQ(result->mesh.positions, mesh.positions);
  EXPECT_EQ(result->keptTriangles, mesh.triangles.size());
  EXPECT_TRUE(result->newTriangles.empty());
}

TEST(Embed, SinksOneSubmoduleWithFourWallsAndAFloor) {
  // One large facet surrounds the pocket. The pocket has 4 walls of 2 triangles and a floor of 2. The facet's 3 corners
  // and the pocket's 4 rim vertices form a ring of 7 triangles.
  const Mesh mesh = shapes::plate({80, 80}, 10, 1, 1);
  const ProjectionFrame frame = makeFrame({11, -9, 0}, kTowardsZ, {0, 1, 0}, 250);
  const DepthField field = fieldOf(3, 3, [](int r, int c) { return r == 1 && c == 1 ? 0.5 : 0.0; });
  const auto result = carve(mesh, frame, field);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(oracle::solidProblems(*result), "");
  EXPECT_EQ(result->keptTriangles, mesh.triangles.size() - 1);
  EXPECT_EQ(result->newTriangles.size(), 8u + 2u + 7u);
  const double expected = oracle::pocketVolume(frame, field, [&](Vec2 p) { return flatDistance(frame, p); });
  EXPECT_NEAR(volumeLost(mesh, *result), expected, 2e-5 * expected);
}

TEST(Embed, KnowsWhereEachFacetComesFrom) {
  using Kind = FacetOrigin::Kind;
  const Mesh mesh = shapes::plate({80, 80}, 10, 1, 1);
  const ProjectionFrame frame = makeFrame({11, -9, 0}, kTowardsZ, {0, 1, 0}, 250);
  const DepthField field = fieldOf(3, 3, [](int r, int c) { return r == 1 && c == 1 ? 0.5 : 0.0; });
  const auto result = carve(mesh, frame, field);
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_EQ(result->origins.size(), result->mesh.triangles.size());
  std::map<Kind, std::size_t> counts;
  std::set<std::uint32_t> cut;
  for (std::size_t t = 0; t < result->origins.size(); ++t) {
    const FacetOrigin& origin = result->origins[t];
    ++counts[origin.kind];
    EXPECT_FALSE(origin.isOfLabel);
    const Vec3 normal = triangleNormal(result->mesh, t);
    for (int k = 0; origin.kind == Kind::Kept && k < 3; ++k)
      EXPECT_EQ(result->mesh.corner(t, k), mesh.corner(origin.facet, k));
    if (origin.kind == Kind::Piece) {
      cut.insert(origin.facet);
      EXPECT_NEAR(glm::distance(normal, triangleNormal(mesh, origin.facet)), 0, 1e-4);
    }
    if (origin.kind == Kind::Floor) {
      EXPECT_NEAR(result->mesh.corner(t, 0).z, -0.5, 0.01);
    }
    if (origin.kind == Kind::Wall) {
      EXPECT_NEAR(normal.z, 0, 0.05);
    }
  }
  EXPECT_EQ(counts, (std::map<Kind, std::size_t>{
                        {Kind::Kept, mesh.triangles.size() - 1}, {Kind::Piece, 7}, {Kind::Floor, 2}, {Kind::Wall, 8}}));
  EXPECT_EQ(cut.size(), 1u);
}

TEST(Embed, CarvesTheBodyOfThePatchAndKeepsTheNumbersOfBodies) {
  Mesh mesh =
      shapes::together(shapes::translated(shapes::box({5, 5, 5}), {100, 0, 0}), shapes::plate({80, 80}, 10, 1, 1));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.bodyOf.push_back(t < 12 ? 0 : 1);
  const ProjectionFrame frame = makeFrame({11, -9, 0}, kTowardsZ, {0, 1, 0}, 250);
  const auto result = carve(mesh, frame, fieldOf(3, 3, [](int r, int c) { return r == 1 && c == 1 ? 0.5 : 0.0; }));
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_EQ(result->mesh.bodyOf.size(), result->mesh.triangles.size());
  for (std::size_t t = 0; t < result->mesh.bodyOf.size(); ++t) EXPECT_EQ(result->mesh.bodyOf[t], t < 12 ? 0u : 1u);
}

TEST(Embed, RemovesTheVolumeOfThePocketsFromAPlate) {
  const Mesh mesh = coarsePlate();
  const ProjectionFrame frame = makeFrame({1.3, 0.7, 0}, kTowardsZ, {0.3, 1, 0}, 250);
  const DepthField field =
      fieldOf(25, 25, [](int r, int c) { return r % 2 == 0 || c % 3 == 0 ? 0.1 + 0.03 * c : 0.0; });
  const auto result = carve(mesh, frame, field);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(oracle::solidProblems(*result), "");
  const double expected = oracle::pocketVolume(frame, field, [&](Vec2 p) { return flatDistance(frame, p); });
  EXPECT_NEAR(volumeLost(mesh, *result), expected, EmbedOptions{}.snapMm * oracle::wallArea(field) / 10);
}

TEST(Embed, MakesPocketsOfAnLShapeOneFloor) {
  const Mesh mesh = shapes::plate({80, 80}, 10, 1, 1);
  const ProjectionFrame frame = makeFrame({11, -9, 0}, kTowardsZ, {0, 1, 0}, 250);
  const auto result = carve(mesh, frame, fieldOf(3, 3, [](int r, int c) { return r == 2 || c == 0 ? 0.5 : 0.0; }));
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(oracle::solidProblems(*result), "");
  // A hexagon has a floor of 4 triangles, walls of 6·2 and a ring of 9 between a triangle and a hexagon.
  EXPECT_EQ(result->newTriangles.size(), 4u + 12u + 9u);
}

TEST(Embed, SeparatesTheSquaresOfACheckerboardByTheChamfer) {
  const Mesh mesh = coarsePlate();
  const ProjectionFrame frame = makeFrame({1.3, 0.7, 0}, kTowardsZ, {0.3, 1, 0}, 250);
  const DepthField field = fieldOf(15, 9, [](int r, int c) { return (r + c) % 2 == 0 ? 0.4 : 0.0; });
  const auto result = carve(mesh, frame, field);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(oracle::solidProblems(*result), "");
  EXPECT_EQ(oracle::eulerCharacteristic(result->mesh), 2);
  // At each of the 14² inner corners both deep cells are chamfered: each loses a kite of two legs, as long as the edge
  // and chamfer/(2·√2) wide.
  const double expected = oracle::pocketVolume(frame, field, [&](Vec2 p) { return flatDistance(frame, p); });
  const double kites = 14 * 14 * 2 * (field.submoduleMm() * EmbedOptions{}.chamferMm / (2 * std::sqrt(2.0)));
  EXPECT_NEAR(volumeLost(mesh, *result), expected - 0.4 * kites, 0.05 * 0.4 * kites);
}

TEST(Embed, LeavesUncarvedSubmodulesEnclosedByCarvedOnesStanding) {
  const Mesh mesh = coarsePlate();
  const ProjectionFrame frame = makeFrame({1.3, 0.7, 0}, kTowardsZ, {0.3, 1, 0}, 250);
  const DepthField field = fieldOf(5, 5, [](int r, int c) { return r == 2 && c == 2 ? 0.0 : 0.3; });
  const auto result = carve(mesh, frame, field);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(oracle::solidProblems(*result), "");
  EXPECT_LT(oracle::largestDepthError(mesh, result->mesh, frame, field, 0.05, 8), 1e-4);
}

TEST(Embed, PutsEveryNewVertexOfAPlateOnADepthOfTheField) {
  const Mesh mesh = coarsePlate();
  const ProjectionFrame frame = makeFrame({1.3, 0.7, 0}, kTowardsZ, {0.3, 1, 0}, 250);
  const DepthField field = fieldOf(10, 8, [](int r, int c) { return 0.05 * ((3 * r + 5 * c) % 7); });
  const auto result = carve(mesh, frame, field);
  ASSERT_TRUE(result) << result.error().message;
  for (const std::uint32_t t : result->newTriangles)
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = result->mesh.corner(t, k);
      const double depth = glm::length(p - frame.eye()) - flatDistance(frame, frame.project(p));
      EXPECT_NEAR(depth, 0.05 * std::round(depth / 0.05), 1e-5);
      EXPECT_LT(depth, 0.305);
    }
}

TEST(Embed, KeepsEveryFacetOutsideThePocketsBitForBitAndInOrder) {
  const Mesh mesh = shapes::bumpySphere(30, 0.5, 3, 5);
  const ProjectionFrame frame = makeFrame({0, 0, 30}, {0.2, 0.1, 1}, {0, 1, 0}, 250);
  const DepthField field = fieldOf(15, 12, [](int r, int c) { return r % 5 == 0 || c % 5 == 0 ? 0.0 : 0.3; });
  const auto result = carve(mesh, frame, field);
  ASSERT_TRUE(result) << result.error().message;
  std::size_t next = 0;
  std::set<CornerTriple> unchanged;
  for (std::size_t t = 0; t < result->keptTriangles; ++t) {
    const CornerTriple corners = cornersOf(result->mesh, t);
    while (next < mesh.triangles.size() && cornersOf(mesh, next) != corners) ++next;
    ASSERT_LT(next++, mesh.triangles.size()) << "facet " << t << " is none of the model's, or out of order";
    unchanged.insert(corners);
  }
  const double h = field.submoduleMm();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Vec2 lo(1e300), hi(-1e300);
    for (int k = 0; k < 3; ++k) {
      lo = glm::min(lo, frame.project(mesh.corner(t, k)) - 0.02);
      hi = glm::max(hi, frame.project(mesh.corner(t, k)) + 0.02);
    }
    bool near = false;
    for (int row = 0; row < field.size; ++row)
      for (int column = 0; column < field.size; ++column) {
        const Vec2 corner = field.corner(row, column);
        near = near || (field.depth(row, column) > 0 && hi.x > corner.x && lo.x < corner.x + h && lo.y < corner.y &&
                        hi.y > corner.y - h);
      }
    if (near && glm::dot(mesh.corner(t, 0), frame.normal) > 0) continue;
    EXPECT_TRUE(unchanged.count(cornersOf(mesh, t))) << "facet " << t << " is far from every pocket";
  }
  EXPECT_EQ(result->newTriangles.front(), result->keptTriangles);
  EXPECT_EQ(result->newTriangles.back() + 1, result->mesh.triangles.size());
}

TEST(Embed, CarvesAlongTheRaysOnCurvedSurfaces) {
  struct Shape {
    const char* name;
    Mesh mesh;
    ProjectionFrame frame;
  };
  const std::vector<Shape> cases{
      {"sphere", shapes::icosphere(30, 4), makeFrame({0, 0, 30}, {0.1, 0.2, 1}, kUp, 250)},
      {"torus", shapes::torus(40, 15, 80, 40), makeFrame({55, 0, 0}, {1, 0.1, 0.2}, kUp, 250)},
      {"cylinder", shapes::cylinder(25, 60, 64), makeFrame({25, 0, 0}, {1, 0, 0}, kUp, 250)},
      {"bumpy sphere", shapes::bumpySphere(40, 1, 3, 5), makeFrame({0, 40, 0}, {0, 1, 0}, kUp, 250)},
      {"edge of a box", shapes::box({50, 50, 50}), makeFrame({25, 25, 0}, {1, 1, 0}, kUp, 250)},
      {"corner of a box", shapes::box({50, 50, 50}), makeFrame({25, 25, 25}, {1, 1, 1}, kUp, 250)},
      {"tip of a tetrahedron", shapes::tetrahedron(60),
       makeFrame(shapes::tetrahedron(60).corner(0, 0), shapes::tetrahedron(60).corner(0, 0), kUp, 250)},
  };
  for (const Shape& shape : cases) {
    SCOPED_TRACE(shape.name);
    const DepthField field =
        fieldOf(20, 16, [](int r, int c) { return (r / 2 + c / 3) % 2 ? 0.0 : 0.2 + 0.01 * (r + c); });
    const auto result = carve(shape.mesh, shape.frame, field);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(oracle::solidProblems(*result), "");
    EXPECT_EQ(oracle::eulerCharacteristic(result->mesh), oracle::eulerCharacteristic(shape.mesh));
    EXPECT_LT(oracle::largestDepthError(shape.mesh, result->mesh, shape.frame, field, 0.1, 4), 5e-4);
  }
}

/// Worst case for the arrangement: the model's vertices and edges lie exactly on the outlines.
TEST(Embed, HandlesAPlateWhoseMeshIsTheSubmoduleGrid) {
  for (const int perSubmodule : {1, 2, 5}) {
    SCOPED_TRACE(perSubmodule);
    const Mesh mesh = shapes::plate({12, 12}, 10, 24 * perSubmodule, 24 * perSubmodule);
    const DepthField field = fieldOf(20, 10, [](int r, int c) {
      return (7 * r + 11 * c + r * c) % 3 == 0 ? 0.0 : 0.01 * ((5 * r + 3 * c) % 40 + 1);
    });
    const auto result = carve(mesh, aboveOrigin(), field);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(oracle::solidProblems(*result), "");
    EXPECT_EQ(oracle::eulerCharacteristic(result->mesh), 2);
    EXPECT_LT(oracle::largestDepthError(mesh, result->mesh, aboveOrigin(), field, 0.05, 4), 1e-4);
  }
}

/// CAD exports have facets only one float wide. They do no harm as they are, but an outline across one, or a copy of
/// one, would collapse.
TEST(Embed, CarvesAcrossNeedlesAFloatWide) {
  Mesh mesh = shapes::plate({40, 36}, 10, 1, 1);
  const Triangle t = mesh.triangles[0];  // upper face; split at points along and just off its longest edge
  std::size_t k = 0;
  const auto length = [&](std::size_t e) { return glm::length(mesh.positions[t[(e + 1) % 3]] - mesh.positions[t[e]]); };
  for (std::size_t e = 1; e < 3; ++e)
    if (length(e) > length(k)) k = e;
  const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
  std::vector<std::uint32_t> chain{a};
  for (const int step : {3, 5, 6, 8}) {
    // Points on the plate's diagonal have exact coordinates; the others lie off it by a convex arc of a few floats.
    Vec3f p = mesh.positions[a] + (mesh.positions[b] - mesh.positions[a]) * (static_cast<float>(step) / 16.0f);
    const float bulge = static_cast<float>(step * (16 - step)) * 0x1p-23f;
    p += (mesh.positions[c] - p) * bulge / glm::length(mesh.positions[c] - p);
    chain.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.push_back(p);
  }
  chain.push_back(b);
  mesh.triangles[0] = {chain[0], chain[1], c};
  for (std::size_t n = 1; n + 1 < chain.size(); ++n) mesh.triangles.push_back({chain[n], chain[n + 1], c});
  for (std::size_t n = 1; n + 1 < chain.size(); ++n) mesh.triangles.push_back({a, chain[n + 1], chain[n]});
  ASSERT_TRUE(checkSolidity(mesh)->solid());
  const ProjectionFrame frame = makeFrame({0.3, 0.2, 0}, {0.1, 0.2, 1}, {0, 1, 0}, 250);
  for (const bool large : {true, false}) {  // needles inside one pocket; needles across many outlines
    const DepthField field =
        large ? fieldOf(2, 21, [](int r, int q) { return 0.3 + 0.1 * ((r + q) % 2); })
              : fieldOf(21, 21, [](int r, int q) { return r % 2 ? 0.3 + 0.01 * ((r + q) % 9) : 0.0; });
    const auto result = carve(mesh, frame, field);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(oracle::solidProblems(*result), "");
    EXPECT_LT(oracle::largestDepthError(mesh, result->mesh, frame, field, 0.1, 16), 2e-3);
  }
}

TEST(Embed, IsDeterministic) {
  const Mesh mesh = shapes::plate({12, 12}, 10, 24, 24);
  const DepthField field = fieldOf(20, 10, [](int r, int c) { return 0.01 * ((5 * r + 3 * c) % 40); });
  const auto first = carve(mesh, aboveOrigin(), field), second = carve(mesh, aboveOrigin(), field);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->mesh.positions, second->mesh.positions);
  EXPECT_EQ(first->mesh.triangles, second->mesh.triangles);
}

TEST(Embed, WorksFarFromTheOriginWhereFloatsAreCoarse) {
  const Vec3 away(900, -700, 800);
  const Mesh mesh = shapes::translated(shapes::bumpySphere(40, 1, 3, 5), away);
  const ProjectionFrame frame = makeFrame(away + Vec3(0, 40, 0), {0, 1, 0}, kUp, 250);
  const DepthField field =
      fieldOf(30, 16, [](int r, int c) { return (r * c) % 3 ? 0.01 * ((5 * r + 3 * c) % 40) : 0.0; });
  const auto result = carve(mesh, frame, field);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(oracle::solidProblems(*result), "");
}

TEST(Embed, ReportsFacetsTooFineForFloats) {
  // Every other strip of the plate is four floats wide, so any piece cut from it collapses.
  const Vec3 away(937, -840, 1001);
  Mesh mesh = shapes::plate({40, 40}, 10, 16, 8);
  for (Vec3f& p : mesh.positions)
    if (const long line = std::lround((p.x + 20) / 2.5f); line % 2 == 1)
      p.x = 2.5f * static_cast<float>(line - 1) - 20 + 0x1p-12f;
  mesh = shapes::translated(mesh, away);
  ASSERT_TRUE(checkSolidity(mesh)->solid());
  const auto result = carve(mesh, makeFrame(away, {0.1, 0.2, 1}, {0, 1, 0}, 250),
                            fieldOf(105, 21, [](int r, int c) { return 0.1 * (1 + (r + c) % 3); }));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::NoSolution);
  EXPECT_THAT(sentence(result.error().message), testing::HasSubstr("too fine"));
  EXPECT_THAT(hint(result.error().message), testing::HasSubstr("erge vertices"));
}

TEST(Embed, ReportsACodeThatExtendsBeyondTheRim) {
  const auto result = carve(coarsePlate(), makeFrame({20, 0, 0}, kTowardsZ, {0, 1, 0}, 250),
                            fieldOf(5, 10, [](int, int) { return 0.3; }));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::NoSolution);
  EXPECT_THAT(sentence(result.error().message), testing::HasSubstr("extends beyond the visible surface"));
  EXPECT_THAT(hint(result.error().message), testing::HasSubstr("smaller size"));
}

TEST(Embed, ReportsACodeOverAHoleOfThePatch) {
  const Mesh mesh = shapes::plate({20, 20}, 10, 40, 40);
  const std::vector<std::uint32_t> patch = oracle::frontPatchWithHole(mesh, aboveOrigin());
  const auto result = embedDepthField(mesh, aboveOrigin(), patch, fieldOf(1, 6, [](int, int) { return 0.3; }));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::NoSolution);
}

TEST(Embed, ReportsThatNoSurfaceLiesUnderTheCode) {
  const Mesh mesh = coarsePlate();
  const auto result = embedDepthField(mesh, aboveOrigin(), {}, fieldOf(1, 6, [](int, int) { return 0.3; }));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::NoSolution);
}

TEST(Embed, RefusesAFacetSeenFromBehind) {
  const Mesh mesh = shapes::insideOut(coarsePlate());
  const std::vector<std::uint32_t> patch{0, 1, 2, 3};
  const auto result = embedDepthField(mesh, aboveOrigin(), patch, fieldOf(1, 30, [](int, int) { return 0.3; }));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::NoSolution);
  EXPECT_THAT(sentence(result.error().message), testing::HasSubstr("from behind"));
}

/// A hundred random codes on random shapes in random places.
TEST(Embed, MakesASolidOfTheRightDepthForAnyFieldAndShape) {
  std::mt19937 random(20221121);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const auto pick = [&](int n) { return static_cast<int>(unit() * n); };
  for (int k = 0; k < 100; ++k) {
    SCOPED_TRACE("case " + std::to_string(k));
    const double away = k % 4 == 0 ? 300 : 20;
    const Vec3 offset = (Vec3(unit(), unit(), unit()) - 0.5) * away;
    const int kind = k % 5;
    Mesh mesh = kind == 0   ? shapes::plate({30, 30}, 10, 1 + pick(60), 1 + pick(60))
                : kind == 1 ? shapes::icosphere(30, 1 + pick(5))
                : kind == 2 ? shapes::bumpySphere(30, 0.3 + unit(), 1 + pick(4), 4)
                : kind == 3 ? shapes::cylinder(20 + 20 * unit(), 60, 12 + pick(200))
                            : shapes::torus(40, 20, 20 + pick(100), 20 + pick(80));
    mesh = shapes::translated(std::move(mesh), offset);
    const Vec3 tilt = (Vec3(unit(), unit(), unit()) - 0.5) * 0.3;
    const Vec3 centre = kind == 0   ? Vec3(unit(), unit(), 0)
                        : kind <= 2 ? Vec3(30, 0, 0)
                        : kind == 3 ? Vec3(20, 0, 5 * unit())
                                    : Vec3(60, 0, 0);
    const Vec3 outwards = kind == 0 ? kTowardsZ : Vec3(1, 0, 0);
    const ProjectionFrame frame = makeFrame(centre + offset, outwards + tilt, {unit(), unit(), 1}, 250);
    const int size = 5 * (1 + pick(4));
    const double symbolMm = 4 + 8 * unit();
    const double share = unit();
    const int depths = k % 3 == 0 ? 2 : 40;
    const DepthField field = fieldOf(size, symbolMm, [&](int, int) {
      return unit() < share ? kDepthQuantumMm * (1 + pick(depths)) * (depths == 2 ? 20 : 1) : 0.0;
    });
    const auto result = carve(mesh, frame, field);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(oracle::solidProblems(*result), "");
    EXPECT_EQ(oracle::eulerCharacteristic(result->mesh), oracle::eulerCharacteristic(mesh));
    EXPECT_LT(oracle::largestDepthError(mesh, result->mesh, frame, field, 0.2 * field.submoduleMm(), 2), 5e-4);
  }
}

TEST(Embed, SaysWhereCoordinatesAreTooCoarse) {
  const Message fine = message<"facets-too-fine">(with::count<"count">(3));
  EXPECT_EQ(whyTooFine(Vec3(100, -8000, 0), fine).code, "facets-too-fine");
  const Message far = whyTooFine(Vec3(10, -40000, 20000), fine);
  EXPECT_EQ(far.code, "coordinates-too-coarse");
  EXPECT_THAT(sentence(far),
              ::testing::HasSubstr("40000 mm from the origin, where 32-bit coordinates are 0.00477 mm apart"));
}

}  // namespace
}  // namespace qrelief
