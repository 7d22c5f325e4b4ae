// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/inlay.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>

#include "carving/carving_oracle.h"
#include "math/tolerance.h"
#include "messages/sentences.h"
#include "support/shapes.h"
#include "verification/solidity.h"

namespace qrelief {
namespace {

using oracle::fieldOf;

const EmbedOptions kWithInlay{.inlay = true};

ProjectionFrame obliquelyAbove(Vec3 centre) { return makeFrame(centre, {0.1, -0.2, 1}, {0.3, 1, 0}, 250); }

std::string problemsOf(const Mesh& mesh) {
  const auto report = checkSolidity(oracle::welded(mesh));
  if (!report) return sentence(report.error().message);
  std::string all = report->vertices == mesh.positions.size() ? "" : "vertices coincide; ";
  for (const Message& problem : report->problems()) all += sentence(problem) + "; ";
  return all;
}

using CornerTriple = std::array<std::array<float, 3>, 3>;

/// Returns a triangle's corner positions, lowest first, in the triangle's order or reversed.
CornerTriple cornersOf(const Mesh& mesh, std::size_t t, bool turned) {
  CornerTriple corners{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3f p = mesh.positions[mesh.triangles[t][turned ? 2 - k : k]];
    corners[k] = {p.x, p.y, p.z};
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// Returns both bodies' triangles without the ones that occur in both, back to back.
Mesh gluedTogether(const Mesh& carved, const Mesh& inlay) {
  std::map<CornerTriple, int> turned;
  for (std::size_t t = 0; t < inlay.triangles.size(); ++t) ++turned[cornersOf(inlay, t, true)];
  std::map<CornerTriple, int> matched;
  Mesh glued = carved;
  glued.triangles.clear();
  for (std::size_t t = 0; t < carved.triangles.size(); ++t) {
    const auto it = turned.find(cornersOf(carved, t, false));
    if (it != turned.end() && it->second-- > 0)
      ++matched[it->first];
    else
      glued.triangles.push_back(carved.triangles[t]);
  }
  const auto offset = static_cast<std::uint32_t>(glued.positions.size());
  glued.positions.insert(glued.positions.end(), inlay.positions.begin(), inlay.positions.end());
  for (std::size_t t = 0; t < inlay.triangles.size(); ++t) {
    if (matched[cornersOf(inlay, t, true)]-- > 0) continue;
    const Triangle& corners = inlay.triangles[t];
    glued.triangles.push_back({corners[0] + offset, corners[1] + offset, corners[2] + offset});
  }
  return oracle::welded(glued);
}

TEST(Inlay, OfOneSubmoduleOnAPlateIsAFrustumOfTwelveTriangles) {
  const Mesh mesh = shapes::plate({80, 80}, 10, 1, 1);
  const ProjectionFrame frame = makeFrame({11, -9, 0}, {0, 0, 1}, {0, 1, 0}, 250);
  const DepthField field = fieldOf(3, 3, [](int r, int c) { return r == 1 && c == 1 ? 0.5 : 0.0; });
  const auto result = oracle::carve(mesh, frame, field, kWithInlay);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->inlay.triangles.size(), 12u);
  EXPECT_EQ(problemsOf(result->inlay), "");
  // Floors lie along rays: their sides grow by the depth's share of the eye distance, each corner on its own ray.
  const double expected =
      oracle::pocketVolume(frame, field, [&](Vec2 p) { return glm::length(frame.onPlane(p) - frame.eye()); });
  EXPECT_NEAR(signedVolume(result->inlay), expected, 2e-5 * expected);
}

TEST(Inlay, IsEmptyUnlessRequested) {
  const auto result =
      oracle::carve(shapes::plate({80, 80}, 10, 1, 1), makeFrame({11, -9, 0}, {0, 0, 1}, {0, 1, 0}, 250),
                    fieldOf(3, 3, [](int, int) { return 0.5; }));
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->inlay.triangles.empty());
}

TEST(Inlay, OfACheckerboardHasOneBodyPerSubmodule) {
  const Mesh mesh = shapes::plate({47, 43}, 10, 3, 2);
  const DepthField field = fieldOf(15, 9, [](int r, int c) { return (r + c) % 2 == 0 ? 0.4 : 0.0; });
  for (const SurfaceMode surface : {SurfaceMode::Preserved, SurfaceMode::Resampled}) {
    const auto result = oracle::carve(mesh, obliquelyAbove({1.3, 0.7, 0}), field, {.surface = surface, .inlay = true});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(problemsOf(result->inlay), "");
    EXPECT_EQ(oracle::eulerCharacteristic(result->inlay), 2 * 113);  // 113 of 15² submodules are carved
  }
}

TEST(Inlay, FillsThePocketsOfAnyFieldAndShapeExactly) {
  std::mt19937 random(20260711);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const auto pick = [&](int n) { return static_cast<int>(unit() * n); };
  for (int k = 0; k < 48; ++k) {
    SCOPED_TRACE("case " + std::to_string(k));
    const SurfaceMode surface = k % 2 ? SurfaceMode::Resampled : SurfaceMode::Preserved;
    const int kind = k / 2 % 4;
    const Mesh mesh = kind == 0   ? shapes::plate({40, 40}, 10, 1 + pick(60), 1 + pick(60))
                      : kind == 1 ? shapes::icosphere(30, 1 + pick(5))
                      : kind == 2 ? shapes::bumpySphere(30, 0.3 + unit(), 1 + pick(3), 4)
                                  : shapes::torus(40, 20, 20 + pick(100), 20 + pick(80));
    const Vec3 centre = kind == 0 ? Vec3(unit(), unit(), 0) : kind <= 2 ? Vec3(30, 0, 0) : Vec3(60, 0, 0);
    const Vec3 outwards = kind == 0 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
    const ProjectionFrame frame =
        makeFrame(centre, outwards + (Vec3(unit(), unit(), unit()) - 0.5) * 0.3, {unit(), unit(), 1}, 250);
    const double share = 0.1 + 0.9 * unit();
    const int depths = k % 3 == 0 ? 1 : 40;
    const DepthField field = fieldOf(5 * (1 + pick(4)), 4 + 8 * unit(), [&](int, int) {
      return unit() < share ? kDepthQuantumMm * (1 + pick(depths)) * (depths == 1 ? 30 : 1) : 0.0;
    });
    const auto result = oracle::carve(mesh, frame, field, {.surface = surface, .inlay = true});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(problemsOf(result->inlay), "");

    // Glued together, the two form a solid without pockets: the model, or the resampled model.
    const Mesh glued = gluedTogether(result->mesh, result->inlay);
    const auto whole = checkSolidity(glued);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->openEdges + whole->nonManifoldEdges + whole->misorientedEdges + whole->nonManifoldVertices, 0u);
    EXPECT_EQ(oracle::eulerCharacteristic(glued), oracle::eulerCharacteristic(mesh));
    const double inlay = signedVolume(result->inlay);
    EXPECT_NEAR(signedVolume(glued) - signedVolume(result->mesh), inlay, 1e-7 * signedVolume(mesh));
    if (surface == SurfaceMode::Preserved) {
      // Cutting a facet moves its plane by the rounding of the cut's ends: 2 µm each at these coordinates.
      EXPECT_NEAR(signedVolume(mesh) - signedVolume(result->mesh), inlay, 2e-6 * field.symbolMm * field.symbolMm * 2);
    }
  }
}

}  // namespace
}  // namespace qrelief
