// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/extruded_outline.h"

#include <cmath>
#include <gtest/gtest.h>

namespace qrelief {
namespace {

const PrintProcess kProcess = *processOf({.nozzleMm = 0.4, .layerMm = 0.2});
constexpr LayerWindow kWindow{Vec2(-4.03), 1.0 / 30, 242, 242};
constexpr Vec2 kCorner{-4.1, -4.2};

/// Returns the segments of an anticlockwise polygon, so that the solid lies on the left.
std::vector<Segment2> polygon(const std::vector<Vec2>& corners) {
  std::vector<Segment2> segments;
  for (std::size_t i = 0; i < corners.size(); ++i) segments.push_back({corners[i], corners[(i + 1) % corners.size()]});
  return segments;
}

std::vector<Segment2> rectangle(Vec2 low, Vec2 high) { return polygon({low, {high.x, low.y}, high, {low.x, high.y}}); }

LayerGrid laid(const std::vector<Segment2>& outline, int winding = 0) {
  return layOutline(outline, kWindow, kCorner, winding, kProcess);
}

TEST(ExtrudedOutline, StraightWallsStayAndCornersAreRoundedByHalfALineWidth) {
  const LayerGrid grid = laid(rectangle({-2, -2}, {2, 2}));
  EXPECT_NEAR(grid.at({2, 0}), 0, 0.005);
  EXPECT_NEAR(grid.at({2.1, 0.3}), 0.1, 0.005);
  EXPECT_NEAR(grid.at({1.96, 0.3}), -0.04, 0.005);
  const double half = kProcess.cornerRadiusMm;
  EXPECT_NEAR(grid.at({2, 2}), half * (std::sqrt(2) - 1), 0.012);
  EXPECT_LT(grid.at({0, 0}), -kProcess.pocketRadiusMm);
}

TEST(ExtrudedOutline, CornersOfPocketsAreRoundedOnlyByTheClosingOfGaps) {
  // An L has its inner corner at the origin, where the solid covers three quarters of the plane.
  const LayerGrid grid = laid(polygon({{-3, -3}, {3, -3}, {3, 0}, {0, 0}, {0, 3}, {-3, 3}}));
  EXPECT_NEAR(grid.at({0, 0}), -kProcess.pocketRadiusMm * (std::sqrt(2) - 1), 0.015);
  EXPECT_NEAR(grid.at({0.12, 0.12}), 0.12, 0.02);
}

TEST(ExtrudedOutline, AThinWallBecomesAsWideAsTheThinnestLine) {
  const LayerGrid grid = laid(rectangle({-2, -0.1}, {2, 0.1}));
  const double half = kProcess.thinnestLineMm / 2;
  EXPECT_NEAR(grid.at({0, half}), 0, 0.025);
  EXPECT_NEAR(grid.at({0, half + 0.1}), 0.1, 0.025);
}

TEST(ExtrudedOutline, AWallJustTooThinForTheOuterLineKeepsItsWidth) {
  const LayerGrid grid = laid(rectangle({-2, -0.2}, {2, 0.2}));
  EXPECT_NEAR(grid.at({0, 0.2}), 0, 0.025);
}

TEST(ExtrudedOutline, OmitsWallsTooThinOrTooShortForALine) {
  EXPECT_GT(laid(rectangle({-2, -0.04}, {2, 0.04})).at({0, 0}), 0) << "thinner than a quarter of the nozzle";
  EXPECT_GT(laid(rectangle({-0.14, -0.14}, {0.14, 0.14})).at({0, 0}), 0) << "an island of 0.28 mm";
}

TEST(ExtrudedOutline, NarrowGapsAreClosedAndWiderOnesStay) {
  std::vector<Segment2> blocks;
  for (const Segment2& segment : rectangle({-3, -2}, {-1, 2})) blocks.push_back(segment);
  for (const Segment2& segment : rectangle({-0.93, -2}, {1, 2})) blocks.push_back(segment);
  for (const Segment2& segment : rectangle({1.2, -2}, {3, 2})) blocks.push_back(segment);
  const LayerGrid grid = laid(blocks);
  EXPECT_LT(grid.at({-0.965, 0}), 0) << "0.07 mm wide";
  EXPECT_NEAR(grid.at({1.1, 0}), 0.1, 0.02) << "0.2 mm wide";
}

TEST(ExtrudedOutline, DropsThinWallsIfTheProcessHasNoLines) {
  const PrintProcess powder = *processOf({.layerMm = 0.1, .technique = PrintTechnique::Powder});
  const auto at = [&](double halfWidth) {
    return layOutline(rectangle({-2, -halfWidth}, {2, halfWidth}), kWindow, kCorner, 0, powder).at({0, 0});
  };
  EXPECT_GT(at(0.9 * powder.cornerRadiusMm), 0);
  EXPECT_LT(at(1.1 * powder.cornerRadiusMm), 0);
}

TEST(ExtrudedOutline, CountsTheSurroundingsFromTheCornerOfTheWindow) {
  // The window lies within the solid, except for a hole.
  std::vector<Segment2> hole = rectangle({-1, -1}, {1, 1});
  for (auto& [a, b] : hole) std::swap(a, b);
  const LayerGrid grid = laid(hole, 1);
  EXPECT_LT(grid.at({-3, 2}), -kProcess.pocketRadiusMm);
  EXPECT_NEAR(grid.at({0, 0.9}), 0.1, 0.005);
  EXPECT_GE(grid.at({0, 0}), kExtrudedReachMm - 1e-6);
}

TEST(ExtrudedOutline, OverlappingSolidsAreOne) {
  // A thin wall stands in a block, partly inside it.
  std::vector<Segment2> two = rectangle({-2, -1}, {2, 1});
  for (const Segment2& segment : rectangle({-0.2, -0.5}, {0.2, 3})) two.push_back(segment);
  const LayerGrid grid = laid(two);
  for (double y = -0.7; y < 2.8; y += 0.1) EXPECT_LT(grid.at({0, y}), -kProcess.pocketRadiusMm) << y;
  EXPECT_NEAR(grid.at({2, 0}), 0, 0.005);
  EXPECT_NEAR(grid.at({0.2, 2}), 0, 0.025);
  const std::vector<Segment2> thin = rectangle({-0.03, -0.5}, {0.03, 3});  // too thin where it leaves the block
  two = rectangle({-2, -1}, {2, 1});
  two.insert(two.end(), thin.begin(), thin.end());
  EXPECT_LT(laid(two).at({0, 0.3}), -kProcess.pocketRadiusMm);
  EXPECT_GT(laid(two).at({0, 2}), 0.1);
}

}  // namespace
}  // namespace qrelief
