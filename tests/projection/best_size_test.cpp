// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/best_size.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "base/random.h"
#include "projection/size.h"

namespace qrelief {
namespace {

using std::numbers::pi;
using std::numbers::sqrt2;

constexpr double kUnbounded = 1e6;

Vec2 polar(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

std::vector<Segment2> polygon(const std::vector<Vec2>& corners) {
  std::vector<Segment2> sides;
  for (std::size_t k = 0; k < corners.size(); ++k) sides.push_back({corners[k], corners[(k + 1) % corners.size()]});
  return sides;
}

/// Returns a polygon with corners on a circle, the first at angle `first`.
std::vector<Segment2> regularPolygon(int corners, double radius, double first) {
  std::vector<Vec2> points;
  for (int k = 0; k < corners; ++k) points.push_back(polar(radius, first + 2 * pi * k / corners));
  return polygon(points);
}

double sizeAt(const std::vector<Segment2>& silhouette, double rotation) {
  return orientedSize(inTurnedAxes(silhouette, rotation));
}

/// Finds the best size by dense sampling, then by halving steps around each of the best samples.
double bestBySampling(const std::vector<Segment2>& silhouette) {
  constexpr int kSamples = 2000;
  constexpr double kStep = pi / 2 / kSamples;
  std::vector<std::pair<double, double>> samples;
  for (int i = 0; i < kSamples; ++i) samples.push_back({sizeAt(silhouette, i * kStep - pi / 4), i * kStep - pi / 4});
  std::sort(samples.rbegin(), samples.rend());
  double best = 0;
  for (int k = 0; k < 12; ++k) {
    auto [size, rotation] = samples[static_cast<std::size_t>(k)];
    for (double step = kStep; step > 1e-14; step /= 2) {
      for (const double turned : {rotation - step, rotation + step}) {
        const double there = sizeAt(silhouette, turned);
        if (there > size) {
          size = there;
          rotation = turned;
        }
      }
    }
    best = std::max(best, size);
  }
  return best;
}

void expectNoRotationIsBetter(const std::vector<Segment2>& silhouette) {
  const TurnedSquare best = bestSize(silhouette, kUnbounded);
  EXPECT_LE(std::abs(best.rotation), pi / 4 + 1e-12);
  EXPECT_NEAR(best.sizeMm, sizeAt(silhouette, best.rotation), 1e-12 * best.sizeMm);
  EXPECT_LE(bestBySampling(silhouette), best.sizeMm * (1 + 1e-9));
  EXPECT_GE(best.sizeMm, orientedSize(silhouette));
  EXPECT_GE(best.sizeMm, freeSize(silhouette) * (1 - 1e-12));
  EXPECT_LE(best.sizeMm, freeSize(silhouette) * sqrt2 * (1 + 1e-12));
}

TEST(BestSize, OfASquareIsTheSquareItself) {
  for (const double turned : {0.0, 0.1, 0.5, -0.3, pi / 4, 1.2}) {
    const TurnedSquare best = bestSize(regularPolygon(4, 20, turned + pi / 4), kUnbounded);
    EXPECT_NEAR(best.sizeMm, 20 * sqrt2, 1e-12) << turned;
    EXPECT_NEAR(std::remainder(best.rotation - turned, pi / 2), 0, 1e-12) << turned;
  }
}

TEST(BestSize, OfARegularPolygonPlacesTheCornersOnItsCorners) {
  // With a multiple of four corners, the square's four corners can lie on them, on the circle that bounds all corners.
  for (const int corners : {8, 12, 40, 360}) {
    const TurnedSquare best = bestSize(regularPolygon(corners, 10, pi / 4 + 0.003), kUnbounded);
    EXPECT_NEAR(best.sizeMm, 10 * sqrt2, 1e-12) << corners;
    EXPECT_NEAR(best.rotation, 0.003, 1e-9) << corners;
  }
}

TEST(BestSize, BetweenTwoParallelLinesIsTheirDistance) {
  for (const double turned : {0.0, 0.2, -0.7}) {
    const Vec2 across = polar(6, turned);
    const Vec2 along = polar(100, turned + pi / 2);
    const std::vector<Segment2> lines{{across - along, across + along}, {-across - along, -across + along}};
    const TurnedSquare best = bestSize(lines, kUnbounded);
    EXPECT_NEAR(best.sizeMm, 12, 1e-12);
    EXPECT_NEAR(best.rotation, turned, 1e-12);
  }
}

TEST(BestSize, BesideOnePointPlacesItInTheMiddleOfASide) {
  const std::vector<Segment2> point{{polar(7, 1.9), polar(7, 1.9)}};
  const TurnedSquare best = bestSize(point, kUnbounded);
  EXPECT_NEAR(best.sizeMm, 14, 1e-12);
  EXPECT_NEAR(best.rotation, 1.9 - pi / 2, 1e-12);
}

TEST(BestSize, BetweenTwoPointsLiesHalfwayModuloAQuarterTurn) {
  // The points lie at 0° and at 60°, which is -30° for a square. The best rotation is 15° off each.
  const std::vector<Segment2> points{{polar(7, 0), polar(7, 0)}, {polar(7, pi / 3), polar(7, pi / 3)}};
  const TurnedSquare best = bestSize(points, kUnbounded);
  EXPECT_NEAR(best.sizeMm, 14 * std::cos(pi / 12), 1e-12);
  EXPECT_NEAR(best.rotation, -pi / 12, 1e-12);
}

TEST(BestSize, IsTheRequestedSizeIfNothingBoundsIt) {
  EXPECT_EQ(bestSize({}, 33).sizeMm, 33);
  EXPECT_EQ(bestSize({}, 33).rotation, 0);
  const std::vector<Segment2> far{{Vec2(100, -100), Vec2(100, 100)}};
  EXPECT_EQ(bestSize(far, 33).sizeMm, 33);
  EXPECT_EQ(bestSize(far, 33).rotation, 0);
}

TEST(BestSize, TurnsNoFartherThanTheMaximumSizeNeeds) {
  // Between lines at ±c, turned by x against the square, half the edge is c/(cos x + sin x) = c/(√2·sin(x + π/4)).
  const Vec2 across = polar(10, 0.6);
  const Vec2 along = polar(200, 0.6 + pi / 2);
  const std::vector<Segment2> lines{{across - along, across + along}, {-across - along, -across + along}};
  const TurnedSquare best = bestSize(lines, 16);
  EXPECT_NEAR(best.sizeMm, 16, 1e-10);
  EXPECT_NEAR(best.rotation, 0.6 - (std::asin(10 / (sqrt2 * 8)) - pi / 4), 1e-9);
}

TEST(BestSize, IsZeroWhereTheSilhouettePassesThroughTheCentre) {
  const std::vector<Segment2> silhouette{{Vec2(-1, -2), Vec2(2, 4)}};
  EXPECT_EQ(bestSize(silhouette, kUnbounded).sizeMm, 0);
}

TEST(BestSize, OfRandomPolygonsIsBetterThanAnySampledRotation) {
  Random random(11);
  for (int k = 0; k < 150; ++k) {
    const int corners = 3 + static_cast<int>(random.uniform(0, 40));
    std::vector<Vec2> points;
    for (int i = 0; i < corners; ++i)
      points.push_back(polar(random.uniform(5, 12), 2 * pi * (i + random.uniform(0, 0.9)) / corners));
    SCOPED_TRACE(k);
    expectNoRotationIsBetter(polygon(points));
  }
}

TEST(BestSize, OfRandomSegmentsIsBetterThanAnySampledRotation) {
  Random random(12);
  for (int k = 0; k < 150; ++k) {
    std::vector<Segment2> segments;
    const int count = 1 + static_cast<int>(random.uniform(0, 30));
    for (int i = 0; i < count; ++i) {
      const Vec2 from(random.uniform(-20, 20), random.uniform(-20, 20));
      segments.push_back({from, from + Vec2(random.uniform(-9, 9), random.uniform(-9, 9))});
    }
    SCOPED_TRACE(k);
    expectNoRotationIsBetter(segments);
  }
}

TEST(BestSize, OfSegmentsAlongTheAxesAndThroughTheirCrossingIsBetterThanAnySampledRotation) {
  // Segments end on the axes and diagonals and lie on lines through the origin: every limit of the curves' ranges at
  // once.
  const std::vector<Segment2> segments{{Vec2(5, 0), Vec2(9, 0)},
                                       {Vec2(0, 6), Vec2(0, 30)},
                                       {Vec2(-7, -7), Vec2(-8, -8)},
                                       {Vec2(-6, 6), Vec2(-6, 0)},
                                       {Vec2(3, -8), Vec2(9, -8)}};
  expectNoRotationIsBetter(segments);
}

TEST(BestSize, DoesNotDependOnWhereTheAxesPoint) {
  Random random(13);
  for (int k = 0; k < 50; ++k) {
    std::vector<Vec2> points;
    for (int i = 0; i < 17; ++i)
      points.push_back(polar(random.uniform(5, 12), 2 * pi * (i + random.uniform(0, 0.9)) / 17));
    const std::vector<Segment2> silhouette = polygon(points);
    const double size = bestSize(silhouette, kUnbounded).sizeMm;
    EXPECT_NEAR(bestSize(inTurnedAxes(silhouette, random.uniform(-4, 4)), kUnbounded).sizeMm, size, 1e-9 * size);
  }
}

}  // namespace
}  // namespace qrelief
