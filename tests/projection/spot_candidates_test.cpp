// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/spot_candidates.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>
#include <set>

#include "support/shapes.h"

namespace qrelief {
namespace {

SizeMap mapOf(const Mesh& mesh, double leastMm) { return makeSizeMap(mesh, vertexNormals(mesh), {.minMm = leastMm}); }

TEST(SpotCandidates, OfACubeAreItsSixFaces) {
  const SizeMap map = mapOf(shapes::box({60, 60, 60}), 40);
  // The middles of faces are 42 mm apart. No other point of a face is both 36 mm from its middle and far from its
  // edges.
  const std::vector<SpotCandidate> spots =
      spotCandidates(map, {.edgeMm = 60, .minSizeMm = 34, .apart = 0.6, .maxCount = 20});
  ASSERT_EQ(spots.size(), 6u);
  std::set<std::pair<int, bool>> faces;
  for (const SpotCandidate& spot : spots)
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(spot.position[axis]) == 30) faces.insert({axis, spot.position[axis] > 0});
  EXPECT_EQ(faces.size(), 6u);
}

TEST(SpotCandidates, KeepTheirDistanceUnlessTheyFaceAway) {
  const SizeMap map = mapOf(shapes::box({150, 150, 5}), 40);
  const std::vector<SpotCandidate> spots = spotCandidates(map, {.edgeMm = 40, .minSizeMm = 40});
  int opposite = 0;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double distance = glm::distance(spots[i].position, spots[j].position);
      const bool away = glm::dot(spots[i].direction, spots[j].direction) < 0;
      EXPECT_TRUE(away || distance >= 20);
      opposite += away && distance < 20 ? 1 : 0;
    }
  }
  EXPECT_GT(opposite, 0);  // one spot lies behind the other
}

TEST(SpotCandidates, RankBySizeFirst) {
  const Mesh balls = shapes::together(shapes::translated(shapes::icosphere(40, 4), {0, 0, 60}),
                                      shapes::translated(shapes::icosphere(20, 4), {0, 0, -30}));
  const SizeMap map = mapOf(balls, 20);
  const std::vector<SpotCandidate> spots = spotCandidates(map, {.edgeMm = 20, .minSizeMm = 1, .maxCount = 200});
  bool small = false;
  for (const SpotCandidate& spot : spots) {
    // Between the balls, each hides part of the other.
    EXPECT_FALSE(small && spot.position.z > 60) << "a spot of the large ball after one of the small";
    small = small || spot.position.z < -30;
  }
  EXPECT_TRUE(small);
}

TEST(CountedSizes, AreWholeInTheMiddleOfAFaceAndLessRoundAnEdge) {
  const SizeMap map = mapOf(shapes::box({60, 60, 60}), 10);
  const std::vector<float> counted = countedSizes(map, 40);
  ASSERT_EQ(counted.size(), map.sizeMm.size());
  float least = 1, most = 0;
  for (std::size_t v = 0; v < counted.size(); ++v) {
    const float fits = std::min(map.sizeMm[v], 40.f);
    ASSERT_LE(counted[v], fits);
    most = std::max(most, counted[v]);
    if (fits > 0) least = std::min(least, counted[v] / fits);
  }
  EXPECT_FLOAT_EQ(most, 40);
  EXPECT_LT(least, 0.9f);
}

TEST(SpotRank, PrefersTheFlatterOfTwoSpotsOfSimilarSize) {
  const SquareQuality flat{.varianceMm2 = 0.1, .worstAngleDeg = 5}, curved{.varianceMm2 = 4, .worstAngleDeg = 40};
  EXPECT_LT(SpotRank(36, flat, 30, 20), SpotRank(37, curved, 30, 20));
  EXPECT_LT(SpotRank(50, curved, 30, 20), SpotRank(36, flat, 30, 20));
}

TEST(SpotRank, CountsASteepSpotAsSmaller) {
  // The cosine of 60° is 0.78 times the cosine of 50°: two classes of 10 %.
  const SquareQuality steep{.varianceMm2 = 1, .worstAngleDeg = 60}, gentle{.varianceMm2 = 1, .worstAngleDeg = 50};
  EXPECT_LT(SpotRank(30, gentle, 30, 20), SpotRank(33, steep, 30, 20));
  EXPECT_LT(SpotRank(45, steep, 30, 20), SpotRank(30, gentle, 30, 20));
  EXPECT_LT(SpotRank(36, gentle, 30, 20), SpotRank(30, SquareQuality{}, 30, 20)) << "at 50° nothing is taken off yet";
}

TEST(SpotRank, CountsASpotWithASmallAimToleranceAsSmaller) {
  const SquareQuality quality{.varianceMm2 = 1, .worstAngleDeg = 30};
  EXPECT_LT(SpotRank(28, quality, 30, 20), SpotRank(33, quality, 30, 6));
  EXPECT_LT(SpotRank(48, quality, 30, 6), SpotRank(22, quality, 30, 20));
  EXPECT_LT(SpotRank(36, quality, 30, 10), SpotRank(30, quality, 30, 45)) << "10° forgive enough";
}

TEST(QualityOf, ReturnsTheAngleOfAnInclinedPlane) {
  const SizeMap map = mapOf(shapes::box({200, 200, 200}), 60);
  const double angle = 25 * std::numbers::pi / 180;
  const ProjectionFrame frame = makeFrame({0, 0, 100}, {std::sin(angle), 0, std::cos(angle)}, {0, 1, 0}, 250);
  const SquareQuality quality = qualityOf(map, frame, 80);
  // Heights change linearly over the square, so they have the variance of a uniform spread of 80·tan 25°.
  const double spread = 80 * std::tan(angle);
  EXPECT_NEAR(quality.varianceMm2, spread * spread / 12, 0.04 * spread * spread / 12);
  EXPECT_NEAR(quality.worstAngleDeg, 25, 1e-3);
  EXPECT_NEAR(quality.bendMm, 0, 1e-6) << "a plane, however inclined";
}

TEST(QualityOf, IsZeroWithoutASurface) {
  const SizeMap map = mapOf(shapes::box({20, 20, 20}), 10);
  const SquareQuality quality = qualityOf(map, makeFrame({100, 0, 0}, {1, 0, 0}, {0, 0, 1}, 250), 20);
  EXPECT_EQ(quality.varianceMm2, 0);
  EXPECT_EQ(quality.worstAngleDeg, 0);
}

}  // namespace
}  // namespace qrelief
