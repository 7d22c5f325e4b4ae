// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/code_estimate.h"

#include <memory>

#include "pipeline/placement.h"
#include "render/gpu_surface.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

/// Fixture with a box of 60 × 60 × 20 mm.
class CodeEstimateTest : public GlTest {
 protected:
  void SetUp() override {
    auto pass = GeometryPass::create();
    ASSERT_TRUE(pass.has_value()) << pass.error().message;
    auto prepared = prepareModel(shapes::soupOf(shapes::box({60, 60, 20})), {});
    ASSERT_TRUE(prepared.has_value());
    prepared_ = std::move(*prepared);
    surface_.emplace(std::make_shared<const GeometryPass>(std::move(*pass)),
                     GpuMesh(prepared_.mesh, vertexNormals(prepared_.mesh)));
  }
  EstimatedSurface box() const { return {prepared_.mesh, *surface_, boundingBox(prepared_.mesh).diagonal()}; }
  PreparedModel prepared_;
  std::optional<GpuSurface> surface_;
};

TEST_F(CodeEstimateTest, AnEstimateOnTopOfABoxAgreesWithTheExactPlacement) {
  const EstimatedSurface surface = box();
  PlacementRequest request;
  request.centreMm = {0, 0, 10};
  request.upHint = {0, 1, 0};
  const SurfacePoint centre = *closestPoint(surface.mesh, request.centreMm);
  const auto estimate = estimateCode(surface, centre, 29, request);
  ASSERT_TRUE(estimate.has_value()) << estimate.error().message;
  PlacementSearch search(prepared_, *surface_, 29, request);
  for (bool done = false; !done;) {
    const auto isDone = search.step();
    ASSERT_TRUE(isDone.has_value()) << isDone.error().message;
    done = *isDone;
  }
  EXPECT_NEAR(estimate->symbolMm, search.placement().symbolMm, 0.03 * search.placement().symbolMm);
  EXPECT_GT(glm::dot(estimate->frame.normal, search.placement().frame.normal), 0.999);
  EXPECT_EQ(estimate->missingFraction, 0);
}

TEST_F(CodeEstimateTest, AWrongExpectationDoesNotChangeAnEstimate) {
  const EstimatedSurface surface = box();
  for (const SizeMode mode : {SizeMode::Free, SizeMode::Oriented}) {
    PlacementRequest request;
    request.sizeMode = mode;
    request.upHint = {0, 1, 0};
    const SurfacePoint centre = *closestPoint(surface.mesh, {3, 2, 10});
    const auto estimate = estimateCode(surface, centre, 29, request);
    ASSERT_TRUE(estimate.has_value()) << estimate.error().message;
    for (const double expectedMm : {0.3, 5.0, 0.9 * estimate->symbolMm, 1.2 * estimate->symbolMm, 500.0}) {
      const auto expecting = estimateCode(surface, centre, 29, request, expectedMm);
      ASSERT_TRUE(expecting.has_value()) << expecting.error().message;
      EXPECT_NEAR(expecting->symbolMm, estimate->symbolMm, 0.03 * estimate->symbolMm) << expectedMm;
      EXPECT_NEAR(expecting->guaranteedMm, estimate->guaranteedMm, 0.03 * estimate->guaranteedMm) << expectedMm;
    }
  }
}

TEST_F(CodeEstimateTest, AFixedSizeThatOverhangsIsEstimatedWithItsShare) {
  const EstimatedSurface surface = box();
  PlacementRequest request;
  request.sizeMode = SizeMode::Fixed;
  request.sizeMm = 40;
  request.quietZone = false;
  request.direction = Vec3(0, 0, 1);
  const SurfacePoint centre = *closestPoint(surface.mesh, {20, 0, 10});
  const auto estimate = estimateCode(surface, centre, 29, request);
  ASSERT_TRUE(estimate.has_value()) << estimate.error().message;
  EXPECT_EQ(estimate->symbolMm, 40);
  EXPECT_NEAR(estimate->missingFraction, 0.25, 0.03);
}

}  // namespace
}  // namespace qrelief
