// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/direction.h"

#include <cmath>

#include "render/gpu_surface.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

/// Returns a map of texels² with normals and distances from a function.
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

TEST(MapSample, AFlatMapReturnsItsNormalInEveryStep) {
  const Vec3 normal = glm::normalize(Vec3(0.3, -0.2, 1));
  const auto map = makeMap(64, [&](double, double) { return std::pair(normal, 240.0); });
  const MapSample sample = sampleMap(map, 64, {});
  EXPECT_LT(glm::length(sample.mean - normal), 1e-6);
  EXPECT_LT(glm::length(sample.depthBalance - normal), 1e-6);
  EXPECT_EQ(sample.outside, Vec3(0));
  EXPECT_EQ(sample.varianceMm2, 0);
  EXPECT_EQ(sample.outsideFraction, 0);
}

TEST(MapSample, TheVarianceOfARampIsItsClosedForm) {
  // Distances are uniform over an interval of length 6: variance 6²/12 = 3, reduced by 1/64² of it for the texels'
  // width.
  const auto map = makeMap(64, [](double x, double) { return std::pair(Vec3(0, 0, 1), 250 + 3 * x); });
  EXPECT_NEAR(sampleMap(map, 64, {}).varianceMm2, 3 * (1 - 1.0 / (64 * 64)), 1e-4);
}

TEST(MapSample, DepthBalanceUsesOnlyTheNearestAndFarthestCells) {
  // The two nearest cells lean left, the two farthest lean right by the same angle, and the rest point up.
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
  EXPECT_DOUBLE_EQ(sample.outsideFraction, 0.25);
  // The cells outside lie at x = 0.5 … 1, y = -1 … 1: (x, y, -1) averages to the right and backwards.
  EXPECT_GT(sample.outside.x, 0.4);
  EXPECT_NEAR(sample.outside.y, 0, 1e-9);
  EXPECT_LT(sample.outside.z, -0.4);
}

TEST(MapSample, APlaneTiltedByAnAngleHasItsClosedFormMeasure) {
  // From far away the distance is u·tan τ over u = -s/2 … s/2, with variance s²·tan² τ/12.
  const double tilt = 0.3;
  DirectionOptions options;
  options.eyeDistanceMm = 2e5;
  options.sizeMm = 1000;
  const auto map = makeMap(128, [&](double x, double) {
    return std::pair(Vec3(std::sin(tilt), 0, std::cos(tilt)), options.eyeDistanceMm + 500 * x * std::tan(tilt));
  });
  const MapSample sample = sampleMap(map, 128, options);
  EXPECT_NEAR(sample.worstAngle, tilt, 0.003);  // the far side appears s/2 / D = 0.0025 more oblique
  EXPECT_NEAR(sample.measure, std::pow(std::tan(tilt), 2) / 12 + 0.02 * (1 - std::cos(sample.worstAngle)), 2e-6);
  EXPECT_LT(glm::length(sample.leastVariance - Vec3(std::sin(tilt), 0, std::cos(tilt))), 0.01);
  EXPECT_TRUE(sample.centreIsSeen);
}

TEST(MapSample, ASurfaceThatFacesTheEyeEverywhereHasMeasureZero) {
  DirectionOptions options;
  const auto map = makeMap(64, [&](double x, double y) {
    const double half = options.sizeMm / 2;
    return std::pair(glm::normalize(Vec3(-x * half, -y * half, options.eyeDistanceMm)), 250.0);
  });
  const MapSample sample = sampleMap(map, 64, options);
  EXPECT_NEAR(sample.worstAngle, 0, 1e-3);
  EXPECT_NEAR(sample.measure, 0, 1e-8);
}

TEST(MapSample, TheWorstAngleIsThe95thPercentile) {
  DirectionOptions options;
  options.eyeDistanceMm = 1e5;
  const auto seenAt = [](double angle) { return Vec3(std::sin(angle), 0, std::cos(angle)); };
  const auto map = makeMap(100, [&](double x, double) {
    return std::pair(seenAt(x > 0.9 ? 1.2 : x > 0.8 ? 1.0 : 0.1), 1e5);
  });
  // Five columns of a hundred are at 1.2; the next five at 1.0.
  EXPECT_NEAR(sampleMap(map, 100, options).worstAngle, 1.2, 1e-3);
}

TEST(MapSample, OutsideTexelsCountAsHalfAnEdgeOffAndEdgeOn) {
  const auto nothing = makeMap(32, [](double, double) { return std::pair(Vec3(0), 0.0); });
  EXPECT_DOUBLE_EQ(sampleMap(nothing, 32, {}).measure, 0.25 + 0.02);
  EXPECT_FALSE(sampleMap(nothing, 32, {}).centreIsSeen);
}

TEST(MapSample, TheCentreIsHiddenIfSomethingIsNearer) {
  const auto near = makeMap(64, [](double, double) { return std::pair(Vec3(0, 0, 1), 245.0); });
  EXPECT_FALSE(sampleMap(near, 64, {}).centreIsSeen);
  const auto at = makeMap(64, [](double, double) { return std::pair(Vec3(0, 0, 1), 249.9); });
  EXPECT_TRUE(sampleMap(at, 64, {}).centreIsSeen);
}

class DirectionTest : public GlTest {
 protected:
  void SetUp() override {
    auto pass = GeometryPass::create();
    ASSERT_TRUE(pass.has_value());
    pass_ = std::make_shared<const GeometryPass>(std::move(*pass));
  }
  /// Runs a search to its end.
  DirectionSearch search(const Mesh& mesh, Vec3 centre, Vec3 normal, DirectionOptions options) {
    surface_.emplace(pass_, GpuMesh(mesh, vertexNormals(mesh)));
    DirectionSearch result(*surface_, centre, normal, {0, 1, 0}, 250, options);
    for (int i = 0; i < 20; ++i) {
      const Result<bool> done = result.step();
      EXPECT_TRUE(done.has_value());
      if (!done || *done) break;
    }
    return result;
  }
  std::shared_ptr<const GeometryPass> pass_;
  std::optional<GpuSurface> surface_;
};

TEST_F(DirectionTest, OnASphereTheDirectionIsTheRadiusForAnyFirstNormal) {
  const Vec3 centre(0, 0, 40);
  for (const DirectionMethod method : {DirectionMethod::MeanNormal, DirectionMethod::DepthBalanced}) {
    DirectionOptions options;
    options.method = method;
    options.sizeMm = 25;
    options.variance = 0;
    const DirectionSearch result = search(shapes::icosphere(40, 6), centre, {0.1, 0.05, 1}, options);
    // With a first look 6.4° off, the mean normal leaves some of the error; five rounds leave almost none.
    const double limit = method == DirectionMethod::MeanNormal ? 0.06 : 0.01;
    EXPECT_LT(glm::length(result.normal() - Vec3(0, 0, 1)), limit) << static_cast<int>(method);
  }
}

TEST_F(DirectionTest, ThePrincipalAxisOfATiltedPlaneIsItsNormal) {
  const Mesh plane = shapes::plate({200, 200}, 80, 4, 4, [](double x, double y) { return 0.3 * x + 0.2 * y; });
  const DirectionSearch result = search(plane, {0, 0, 0}, {0.2, 0, 1}, {.method = DirectionMethod::Pca, .sizeMm = 30});
  EXPECT_LT(glm::length(result.normal() - glm::normalize(Vec3(-0.3, -0.2, 1))), 1e-4);
  EXPECT_EQ(result.iterations().size(), 2u);
  EXPECT_EQ(result.iterations()[1].normal, result.normal());
}

TEST_F(DirectionTest, ThePrincipalAxisOfASphereACylinderAndASaddlePointsOutwards) {
  DirectionOptions options;
  options.method = DirectionMethod::Pca;
  options.sizeMm = 25;
  const DirectionSearch sphere = search(shapes::icosphere(40, 6), {0, 0, 40}, {0, 0, 1}, options);
  EXPECT_LT(glm::length(sphere.normal() - Vec3(0, 0, 1)), 0.01);
  const DirectionSearch cylinder = search(shapes::cylinder(30, 120, 96), {30, 0, 0}, {1, 0, 0}, options);
  EXPECT_LT(glm::length(cylinder.normal() - Vec3(1, 0, 0)), 0.01);
  const Mesh saddle = shapes::plate({80, 80}, 40, 80, 80, [](double x, double y) { return 0.01 * (x * x - y * y); });
  EXPECT_LT(glm::length(search(saddle, {0, 0, 0}, {0, 0, 1}, options).normal() - Vec3(0, 0, 1)), 0.01);
}

TEST_F(DirectionTest, OnAFlatFaceItStopsAfterOneUpdate) {
  const DirectionSearch result = search(shapes::box({80, 80, 20}), {0, 0, 10}, {0, 0, 1}, {.sizeMm = 30});
  EXPECT_EQ(result.iterations().size(), 2u);
  EXPECT_LT(glm::length(result.normal() - Vec3(0, 0, 1)), 1e-5);
}

TEST_F(DirectionTest, OverAnEdgeTheDirectionEndsBetweenTheTwoFaces) {
  DirectionOptions options;
  options.sizeMm = 30;
  const DirectionSearch result = search(shapes::box({80, 80, 80}), {38, 0, 40}, {0, 0, 1}, options);
  EXPECT_GT(result.normal().x, 0.3);
  EXPECT_GT(result.normal().z, 0.3);
  EXPECT_NEAR(result.normal().y, 0, 0.05);
  EXPECT_EQ(result.iterations().size(), 6u);
  double least = 1e9;
  for (std::size_t i = 1; i < result.iterations().size(); ++i)
    least = std::min(least, result.iterations()[i].varianceMm2);
  for (const DirectionIteration& i : result.iterations()) {
    if (i.normal != result.normal()) continue;
    EXPECT_EQ(i.varianceMm2, least);
  }
}

}  // namespace
}  // namespace qrelief
