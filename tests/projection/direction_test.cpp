// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/direction.h"

#include <cmath>

#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

/// A map of texels² whose normals and distances a function gives.
template <class Function>
std::vector<float> makeMap(int texels, Function at) {
  std::vector<float> map;
  for (int row = 0; row < texels; ++row)
    for (int column = 0; column < texels; ++column) {
      const auto [normal, distance] = at((column + 0.5) / texels * 2 - 1, (row + 0.5) / texels * 2 - 1);
      for (const double v : {normal.x, normal.y, normal.z, distance}) map.push_back(static_cast<float>(v));
    }
  return map;
}

TEST(MapSample, AFlatMapGivesItsNormalInEveryStep) {
  const Vec3 normal = glm::normalize(Vec3(0.3, -0.2, 1));
  const auto map = makeMap(64, [&](double, double) { return std::pair(normal, 240.0); });
  const MapSample sample = sampleMap(map, 64, {});
  EXPECT_LT(glm::length(sample.mean - normal), 1e-6);
  EXPECT_LT(glm::length(sample.depthBalance - normal), 1e-6);
  EXPECT_EQ(sample.outside, Vec3(0));
  EXPECT_EQ(sample.varianceMm2, 0);
  EXPECT_EQ(sample.outsideShare, 0);
}

TEST(MapSample, TheVarianceOfARampIsItsClosedForm) {
  // Distances uniform over an interval of length 6: variance 6²/12 = 3, less 1/64² of it for the texels' width.
  const auto map = makeMap(64, [](double x, double) { return std::pair(Vec3(0, 0, 1), 250 + 3 * x); });
  EXPECT_NEAR(sampleMap(map, 64, {}).varianceMm2, 3 * (1 - 1.0 / (64 * 64)), 1e-4);
}

TEST(MapSample, DepthBalanceTakesOnlyTheNearestAndFarthestCells) {
  // Two cells are nearest and lean left, two are farthest and lean right by the same angle, the rest point up.
  const auto map = makeMap(64, [](double x, double y) {
    if (y > 0.75 && x < -0.5) return std::pair(glm::normalize(Vec3(-1, 0, 1)), 200.0);
    if (y > 0.75 && x > 0.5) return std::pair(glm::normalize(Vec3(1, 0.5, 1)), 300.0);
    return std::pair(Vec3(0, 0, 1), 250.0);
  });
  const Vec3 expected = glm::normalize(glm::normalize(Vec3(-1, 0, 1)) + glm::normalize(Vec3(1, 0.5, 1)));
  EXPECT_LT(glm::length(sampleMap(map, 64, {}).depthBalance - expected), 1e-6);
}

TEST(MapSample, AnOverhangTurnsTheDirectionTowardsTheOverhangingSide) {
  const auto map = makeMap(64, [](double x, double) { return std::pair(Vec3(0, 0, 1), x > 0.5 ? 0.0 : 250.0); });
  const MapSample sample = sampleMap(map, 64, {});
  EXPECT_DOUBLE_EQ(sample.outsideShare, 0.25);
  // The cells outside lie at x = 0.5 … 1, y = -1 … 1: (x, y, -1) averages to the right and backwards.
  EXPECT_GT(sample.outside.x, 0.4);
  EXPECT_NEAR(sample.outside.y, 0, 1e-9);
  EXPECT_LT(sample.outside.z, -0.4);
}

class DirectionTest : public GlTest {
 protected:
  void SetUp() override {
    auto made = GeometryPass::create();
    ASSERT_TRUE(made.has_value());
    pass_ = std::move(*made);
  }
  /// Runs a search to its end.
  DirectionSearch search(const Mesh& mesh, Vec3 centre, Vec3 normal, DirectionOptions options) {
    gpu_ = GpuMesh(mesh, vertexNormals(mesh));
    DirectionSearch made(pass_, gpu_, centre, normal, {0, 1, 0}, 250, options);
    for (int i = 0; i < 20; ++i) {
      const Result<bool> done = made.step();
      EXPECT_TRUE(done.has_value());
      if (!done || *done) break;
    }
    return made;
  }
  GeometryPass pass_;
  GpuMesh gpu_;
};

TEST_F(DirectionTest, OnASphereTheDirectionIsTheRadiusWhateverTheFirstNormal) {
  const Vec3 centre(0, 0, 40);
  for (const DirectionMethod method : {DirectionMethod::MeanNormal, DirectionMethod::DepthBalanced}) {
    DirectionOptions options;
    options.method = method;
    options.sizeMm = 25;
    options.variance = 0;
    const DirectionSearch found = search(shapes::icosphere(40, 6), centre, {0.1, 0.05, 1}, options);
    // The mean from a first look that is 6.4° wrong leaves some of the error, five rounds leave next to none.
    const double limit = method == DirectionMethod::MeanNormal ? 0.06 : 0.01;
    EXPECT_LT(glm::length(found.normal() - Vec3(0, 0, 1)), limit) << static_cast<int>(method);
  }
}

TEST_F(DirectionTest, OnAFlatFaceItStopsAfterOneUpdate) {
  const DirectionSearch found = search(shapes::box({80, 80, 20}), {0, 0, 10}, {0, 0, 1}, {.sizeMm = 30});
  EXPECT_EQ(found.iterations().size(), 2u);
  EXPECT_LT(glm::length(found.normal() - Vec3(0, 0, 1)), 1e-5);
}

TEST_F(DirectionTest, OverAnEdgeTheDirectionEndsBetweenTheTwoFaces) {
  DirectionOptions options;
  options.sizeMm = 30;
  const DirectionSearch found = search(shapes::box({80, 80, 80}), {38, 0, 40}, {0, 0, 1}, options);
  EXPECT_GT(found.normal().x, 0.3);
  EXPECT_GT(found.normal().z, 0.3);
  EXPECT_NEAR(found.normal().y, 0, 0.05);
  EXPECT_EQ(found.iterations().size(), 6u);
  double least = 1e9;
  for (std::size_t i = 1; i < found.iterations().size(); ++i)
    least = std::min(least, found.iterations()[i].varianceMm2);
  for (const DirectionIteration& i : found.iterations()) {
    if (i.normal != found.normal()) continue;
    EXPECT_EQ(i.varianceMm2, least);
  }
}

}  // namespace
}  // namespace qrelief
