// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/spot_trial.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "support/shapes.h"

namespace qrelief {
namespace {

std::shared_ptr<const EngravableModel> modelOf(const Mesh& mesh) {
  auto prepared = prepareModel(shapes::soupOf(mesh), {});
  EXPECT_TRUE(prepared.has_value());
  return EngravableModel::create(std::move(*prepared), nullptr);
}

SpotTrial finished(const EngravableModel& model, const SpotSearchRequest& request, const SizeMap& map,
                   const SpotCandidate& candidate) {
  SpotTrial trial(model, request, map, candidate, false);
  for (;;) {
    const Result<bool> isDone = trial.step();
    EXPECT_TRUE(isDone.has_value());
    if (!isDone || *isDone) return trial;
  }
}

TEST(SpotTrial, OneAfterAnotherFindTheSpotsOfTheSearch) {
  const auto model = modelOf(shapes::bumpySphere(40, 3, 4, 4));
  SpotSearchRequest request;
  request.placement.sizeMode = SizeMode::Best;
  request.placement.maxSizeMm = 30;
  request.count = 4;
  const auto search = findSpots(model, request);
  ASSERT_TRUE(search.has_value());
  ASSERT_EQ(search->spots.size(), 4u);
  for (const Spot& spot : search->spots) {
    const SpotCandidate candidate{spot.centreMm, spot.direction, spot.symbolMm, {}};
    const SpotTrial trial = finished(*model, request, *search->map, candidate);
    ASSERT_TRUE(trial.spot().has_value());
    EXPECT_EQ(trial.tries(), 1u);
    EXPECT_EQ(trial.spot()->centreMm, spot.centreMm);
    EXPECT_EQ(trial.spot()->direction, spot.direction);
    EXPECT_EQ(trial.spot()->symbolMm, spot.symbolMm);
    EXPECT_EQ(trial.spot()->guaranteedMm, spot.guaranteedMm);
    EXPECT_EQ(trial.spot()->unevenLight, spot.unevenLight);
  }
}

TEST(SpotTrial, TriesBothDirectionsBeforeItReportsAThinWall) {
  // A wall of 1 mm takes no pockets of 0.5 mm.
  const auto model = modelOf(shapes::box({60, 60, 1}));
  SpotSearchRequest request;
  request.placement.sizeMode = SizeMode::Fixed;
  request.placement.sizeMm = 20;
  request.leastDepthMm = 0.5;
  const SizeMap map = makeSizeMap(model->prepared.mesh, model->prepared.normals, {.minMm = 20});
  const SpotTrial trial = finished(*model, request, map, {{0, 0, 0.5}, {0, 0, 1}, 40, {}});
  EXPECT_FALSE(trial.spot().has_value());
  EXPECT_EQ(trial.tries(), 2u);
  ASSERT_TRUE(trial.thinWallMm().has_value());
  EXPECT_NEAR(*trial.thinWallMm(), 1, 0.05);
}

TEST(SpotTrial, NamesAShellWithinAWallThatIsTooThin) {
  // A slab of 1 mm reaches 0.2 mm into a thick one.
  const auto model =
      modelOf(shapes::together(shapes::box({60, 60, 20}), shapes::translated(shapes::box({60, 60, 1}), {0, 0, 10.3})));
  SpotSearchRequest request;
  request.placement.sizeMode = SizeMode::Fixed;
  request.placement.sizeMm = 20;
  request.placement.direction = Vec3(0, 0, 1);
  request.leastDepthMm = 0.5;
  request.offersThinWalls = true;
  const SizeMap map = makeSizeMap(model->prepared.mesh, model->prepared.normals, {.minMm = 20});
  const SpotTrial trial = finished(*model, request, map, {{0, 0, 10.8}, {0, 0, 1}, 40, {}});
  ASSERT_TRUE(trial.spot().has_value());
  ASSERT_FALSE(trial.spot()->concerns.empty());
  EXPECT_EQ(trial.spot()->concerns.front().code, "nothing-can-be-carved-over-shell");
}

TEST(SpotTrial, TellsWhetherCrossingsKeepTheCodeAway) {
  // A column comes through the face along x = 8; the face ends at x = -20.
  const auto model =
      modelOf(shapes::together(shapes::box({40, 40, 10}), shapes::translated(shapes::box({4, 60, 30}), {10, 0, 0})));
  SpotSearchRequest request;
  request.placement.sizeMode = SizeMode::Fixed;
  request.placement.sizeMm = 12;
  request.placement.direction = Vec3(0, 0, 1);
  const SizeMap map = makeSizeMap(model->prepared.mesh, model->prepared.normals, {.minMm = 4});
  const auto isMet = [&](Vec3 centre) {
    const SpotTrial trial = finished(*model, request, map, {centre, {0, 0, 1}, 40, {}});
    EXPECT_FALSE(trial.spot().has_value());
    return trial.meetsCrossings();
  };
  EXPECT_TRUE(isMet({6, 1, 5}));
  EXPECT_FALSE(isMet({-18, 1, 5}));
}

TEST(SpotTrial, OffersNoSpotBesideASurfaceThatIsTooSmall) {
  const auto model = modelOf(shapes::box({60, 60, 10}));
  SpotSearchRequest request;
  request.placement.sizeMode = SizeMode::Fixed;
  request.placement.sizeMm = 50;
  const SizeMap map = makeSizeMap(model->prepared.mesh, model->prepared.normals, {.minMm = 20});
  const SpotTrial trial = finished(*model, request, map, {{28, 0, 5}, {0, 0, 1}, 50, {}});
  EXPECT_FALSE(trial.spot().has_value());
  EXPECT_FALSE(trial.thinWallMm().has_value());
}

}  // namespace
}  // namespace qrelief
