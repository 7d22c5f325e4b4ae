// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/eye_reach.h"

#include <cmath>
#include <numbers>

#include "support/gl_test.h"
#include "support/shapes.h"
#include "viewer/code_estimate.h"

namespace qrelief {
namespace {

class EyeReachTest : public GlTest {
 protected:
  void SetUp() override {
    auto made = GeometryPass::create();
    ASSERT_TRUE(made.has_value()) << made.error().message;
    pass_ = std::make_unique<GeometryPass>(std::move(*made));
  }
  static std::shared_ptr<const EngravableModel> upload(const Mesh& mesh) {
    auto prepared = prepareModel(shapes::soupOf(mesh), {});
    EXPECT_TRUE(prepared.has_value());
    return EngravableModel::upload(std::move(*prepared));
  }
  EyeReach look(const Mesh& mesh, Vec3 centre, double extentMm) {
    const auto model = upload(mesh);
    auto reach =
        lookAround(lookByRendering(*pass_, model->gpu), makeFrame(centre, {0, 0, 1}, {0, 1, 0}, 250), {extentMm, 128});
    EXPECT_TRUE(reach.has_value());
    return *reach;
  }
  std::unique_ptr<GeometryPass> pass_;
};

TEST_F(EyeReachTest, SquaresOnABoxesTopAreTheClosedFormToATexel) {
  const EyeReach reach = look(shapes::box({60, 60, 20}), {0, 0, 10}, 100);
  const double texel = reach.window.texelMm();
  EXPECT_NEAR(reach.freeMm(), std::numbers::sqrt2 * 30, 2 * texel);
  EXPECT_NEAR(reach.alignedMm(0), 60, 2 * texel);
  EXPECT_NEAR(reach.alignedMm(std::numbers::pi / 4), std::numbers::sqrt2 * 30, 2 * texel);
}

TEST_F(EyeReachTest, TheShareThatMissesIsThatOfTheAreas) {
  const EyeReach reach = look(shapes::box({60, 60, 20}), {10, 0, 10}, 100);
  EXPECT_EQ(reach.missingShare(38, 0), 0);
  // Of a square of 60 mm about the centre 10 mm lie beyond the edge.
  EXPECT_NEAR(reach.missingShare(60, 0), 1 / 6.0, 0.03);
}

TEST_F(EyeReachTest, WhatStandsApartIsSeenButNotReached) {
  const Mesh two =
      shapes::together(shapes::box({20, 20, 20}), shapes::translated(shapes::box({20, 20, 20}), {25, 0, 0}));
  EyeReach reach = look(two, {0, 0, 10}, 80);
  const auto texel = [&](double x) { return static_cast<int>((x / 80 + 0.5) * 128); };
  EXPECT_TRUE(reach.isReached(texel(8), 64));
  EXPECT_FALSE(reach.isReached(texel(25), 64));
  reach.trust();
  EXPECT_TRUE(reach.isReached(texel(25), 64));
}

TEST_F(EyeReachTest, NothingIsReachedFromACentreThatIsHidden) {
  const Mesh two =
      shapes::together(shapes::box({20, 20, 20}), shapes::translated(shapes::box({20, 20, 2}), {0, 0, 60}));
  const EyeReach reach = look(two, {0, 0, 10}, 40);
  EXPECT_LT(reach.freeMm(), reach.window.texelMm());
  EXPECT_EQ(reach.missingShare(10, 0), 1);
}

TEST_F(EyeReachTest, AnEstimateOnABoxesTopAgreesWithTheExactPlacement) {
  const auto model = upload(shapes::box({60, 60, 20}));
  PlacementRequest request;
  request.centreMm = {0, 0, 10};
  request.upHint = {0, 1, 0};
  const SurfacePoint centre = *closestPoint(model->prepared.mesh, request.centreMm);
  const auto estimate = estimateCode(*model, lookByRendering(*pass_, model->gpu), centre, 29, request);
  ASSERT_TRUE(estimate.has_value()) << estimate.error().message;
  PlacementSearch search(model->prepared, model->gpu, *pass_, 29, request);
  for (bool done = false; !done;) {
    const auto found = search.step();
    ASSERT_TRUE(found.has_value()) << found.error().message;
    done = *found;
  }
  EXPECT_NEAR(estimate->symbolMm, search.placement().symbolMm, 0.03 * search.placement().symbolMm);
  EXPECT_GT(glm::dot(estimate->frame.normal, search.placement().frame.normal), 0.999);
  EXPECT_EQ(estimate->missingShare, 0);
}

TEST_F(EyeReachTest, AWrongExpectationDoesNotChangeAnEstimate) {
  const auto model = upload(shapes::box({60, 60, 20}));
  for (const SizeMode mode : {SizeMode::Free, SizeMode::Oriented}) {
    PlacementRequest request;
    request.sizeMode = mode;
    request.upHint = {0, 1, 0};
    const SurfacePoint centre = *closestPoint(model->prepared.mesh, {3, 2, 10});
    const auto estimate = estimateCode(*model, lookByRendering(*pass_, model->gpu), centre, 29, request);
    ASSERT_TRUE(estimate.has_value()) << estimate.error().message;
    for (const double expectedMm : {0.3, 5.0, 0.9 * estimate->symbolMm, 1.2 * estimate->symbolMm, 500.0}) {
      const auto expecting = estimateCode(*model, lookByRendering(*pass_, model->gpu), centre, 29, request, expectedMm);
      ASSERT_TRUE(expecting.has_value()) << expecting.error().message;
      EXPECT_NEAR(expecting->symbolMm, estimate->symbolMm, 0.03 * estimate->symbolMm) << expectedMm;
      EXPECT_NEAR(expecting->guaranteedMm, estimate->guaranteedMm, 0.03 * estimate->guaranteedMm) << expectedMm;
    }
  }
}

TEST_F(EyeReachTest, AFixedSizeThatOverhangsIsEstimatedWithItsShare) {
  const auto model = upload(shapes::box({60, 60, 20}));
  PlacementRequest request;
  request.sizeMode = SizeMode::Fixed;
  request.sizeMm = 40;
  request.quietZone = false;
  request.direction = Vec3(0, 0, 1);
  const SurfacePoint centre = *closestPoint(model->prepared.mesh, {20, 0, 10});
  const auto estimate = estimateCode(*model, lookByRendering(*pass_, model->gpu), centre, 29, request);
  ASSERT_TRUE(estimate.has_value()) << estimate.error().message;
  EXPECT_EQ(estimate->symbolMm, 40);
  EXPECT_NEAR(estimate->missingShare, 0.25, 0.03);
}

TEST(Turned, ATurnedFrameHasItsRightWhereUpWas) {
  const ProjectionFrame frame = makeFrame({1, 2, 3}, {0, 0, 1}, {0, 1, 0}, 250);
  const ProjectionFrame quarter = turned(frame, std::numbers::pi / 2);
  EXPECT_LT(glm::length(quarter.right - frame.up), 1e-12);
  EXPECT_LT(glm::length(quarter.up + frame.right), 1e-12);
}

}  // namespace
}  // namespace qrelief
