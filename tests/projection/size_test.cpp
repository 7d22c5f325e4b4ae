// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/size.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "base/random.h"

namespace qrelief {
namespace {

TEST(Size, IsUnboundedWithoutSilhouette) {
  EXPECT_TRUE(std::isinf(freeSize({})));
  EXPECT_TRUE(std::isinf(orientedSize({})));
  EXPECT_FALSE(nearestSilhouettePoint({}).has_value());
}

TEST(Size, IsMeasuredToTheMiddleOfAnEdgeNotToItsVertices) {
  const std::vector<Segment2> silhouette{{Vec2(-30, 4), Vec2(30, 4)}, {Vec2(-9, -9), Vec2(9, -9)}};
  EXPECT_DOUBLE_EQ(freeSize(silhouette), 4 * std::sqrt(2));
  EXPECT_DOUBLE_EQ(orientedSize(silhouette), 8);
  EXPECT_EQ(*nearestSilhouettePoint(silhouette), Vec2(0, 4));
}

TEST(Size, AllowsAnAlignedSquareMoreThanAnyRotation) {
  // The corner of a notch lies at (10, 3): 10 to the side, √109 away.
  const std::vector<Segment2> silhouette{{Vec2(10, 3), Vec2(40, 3)}};
  EXPECT_DOUBLE_EQ(orientedSize(silhouette), 20);
  EXPECT_DOUBLE_EQ(freeSize(silhouette), std::sqrt(2 * 109.0));
}

TEST(Size, StopsAlongADiagonalSideAtTheSquaresCorner) {
  // On |u| + |v| = 10, the square's corner touches at (5, 5).
  const std::vector<Segment2> silhouette{{Vec2(10, 0), Vec2(0, 10)}};
  EXPECT_DOUBLE_EQ(orientedSize(silhouette), 10);
  EXPECT_DOUBLE_EQ(freeSize(silhouette), 10);
}

TEST(Size, IsZeroWhereTheSilhouettePassesThroughTheCentre) {
  const std::vector<Segment2> silhouette{{Vec2(-1, -2), Vec2(2, 4)}};
  EXPECT_DOUBLE_EQ(freeSize(silhouette), 0);
  EXPECT_DOUBLE_EQ(orientedSize(silhouette), 0);
}

TEST(Size, TreatsASegmentWithoutLengthAsAPoint) {
  const std::vector<Segment2> silhouette{{Vec2(-3, 4), Vec2(-3, 4)}};
  EXPECT_DOUBLE_EQ(freeSize(silhouette), 5 * std::sqrt(2));
  EXPECT_DOUBLE_EQ(orientedSize(silhouette), 8);
}

TEST(Size, AgreesWithADenselySampledSegment) {
  Random random(3);
  const auto point = [&] { return Vec2(random.uniform(-10, 10), random.uniform(-10, 10)); };
  for (int k = 0; k < 200; ++k) {
    const Segment2 segment{point(), point()};
    double euclidean = 1e9;
    double maximum = 1e9;
    const int samples = 20000;
    for (int i = 0; i <= samples; ++i) {
      const Vec2 p = segment[0] + (segment[1] - segment[0]) * (static_cast<double>(i) / samples);
      euclidean = std::min(euclidean, glm::length(p));
      maximum = std::min(maximum, std::max(std::abs(p.x), std::abs(p.y)));
    }
    const double step = glm::distance(segment[0], segment[1]) / samples;
    const std::vector<Segment2> silhouette{segment};
    EXPECT_LE(orientedSize(silhouette), 2 * maximum + 1e-12);
    EXPECT_GE(orientedSize(silhouette), 2 * (maximum - step));
    EXPECT_LE(freeSize(silhouette), std::sqrt(2) * euclidean + 1e-12);
    EXPECT_GE(freeSize(silhouette), std::sqrt(2) * (euclidean - step));
  }
}

}  // namespace
}  // namespace qrelief
