// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/mark_depth.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "qr/module_pattern.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

const Printer kPrinter;  // lines of 0.45 mm, layers of 0.2 mm

TEST(OpaqueDepth, IsTwoLayersFacingUpAndTwoLinesOnAWall) {
  EXPECT_DOUBLE_EQ(opaqueDepthMm(0, kPrinter), 0.4);
  EXPECT_DOUBLE_EQ(opaqueDepthMm(std::numbers::pi, kPrinter), 0.4);
  EXPECT_DOUBLE_EQ(opaqueDepthMm(std::numbers::pi / 2, kPrinter), 0.9);
  EXPECT_DOUBLE_EQ(deepestInlayMm(kPrinter), 0.9);
}

TEST(OpaqueDepth, BetweenThemTheBodyIsAtLeastTwoLayersHighAndTwoLinesWide) {
  for (double facing = 0.01; facing < 1.56; facing += 0.05) {
    const double depth = opaqueDepthMm(facing, kPrinter);
    EXPECT_GE(depth / std::cos(facing), 0.4 - 1e-12);
    EXPECT_GE(depth / std::sin(facing), 0.9 - 1e-12);
    EXPECT_LE(depth, 0.9);
  }
}

Placement placementOn(const Mesh& mesh, const ProjectionFrame& frame, double symbolMm) {
  Placement placement;
  placement.frame = frame;
  placement.symbolMm = symbolMm;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (glm::dot(triangleNormal(mesh, t), frame.normal) > 0.3) placement.patch.triangles.push_back(t);
  return placement;
}

TEST(InlayDepth, FollowsTheSlopeOfAPlane) {
  const Mesh mesh = shapes::plate({60, 60}, 10, 30, 30);
  const Placement placement = placementOn(mesh, makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1e5), 30);
  EXPECT_NEAR(inlayDepthMm(mesh, placement, {0, 0, 1}, kPrinter), 0.4, 1e-6);
  EXPECT_NEAR(inlayDepthMm(mesh, placement, {0, 5, 0}, kPrinter), 0.9, 1e-6);
  EXPECT_NEAR(inlayDepthMm(mesh, placement, {0, 1, 1}, kPrinter), 0.9 * std::numbers::sqrt2 / 2, 1e-6);
}

TEST(InlayDepth, AFacetLargerThanTheCodeCounts) {
  const Mesh mesh = shapes::box({100, 100, 10});
  const Placement placement = placementOn(mesh, makeFrame({5, 5, 5}, {0, 0, 1}, {0, 1, 0}, 250), 10);
  EXPECT_NEAR(inlayDepthMm(mesh, placement, {0, 0, 1}, kPrinter), 0.4, 1e-6);
}

class InlayPocketsTest : public testing::Test {
 protected:
  InlayPocketsTest() : symbol_(*encodeSymbol("HELLO", {.version = 1})) {
    limits_.assign(static_cast<std::size_t>(105 * 105), 0.6);
  }
  double& limit(int row, int column) { return limits_[static_cast<std::size_t>((5 * row + 2) * 105 + 5 * column + 2)]; }

  const Symbol symbol_;
  std::vector<double> limits_;
};

TEST_F(InlayPocketsTest, AreWholeModulesOfOneDepth) {
  const InlayPockets pockets = inlayPockets(symbol_, 21, limits_, 0.6);
  EXPECT_DOUBLE_EQ(pockets.depthMm, 0.6);
  EXPECT_EQ(pockets.leftOut, 0u);
  const SubmoduleMask dark = submodulesToCarve(symbol_, ModulePattern::None, FinderPattern::None);
  for (std::size_t i = 0; i < dark.size(); ++i) ASSERT_EQ(pockets.depths.depthMm[i], dark[i] ? pockets.depthMm : 0);
}

TEST_F(InlayPocketsTest, AThinWallMakesAllShallowerAndAVeryThinOneCostsItsModule) {
  limit(0, 0) = 0.437;
  EXPECT_DOUBLE_EQ(inlayPockets(symbol_, 21, limits_, 0.6).depthMm, 0.43);
  limit(0, 0) = 0.29;
  const InlayPockets pockets = inlayPockets(symbol_, 21, limits_, 0.6);
  EXPECT_DOUBLE_EQ(pockets.depthMm, 0.6);
  EXPECT_EQ(pockets.leftOut, 1u);
  EXPECT_EQ(pockets.depths.depth(1, 1), 0);
  EXPECT_DOUBLE_EQ(pockets.depths.depth(1, 6), 0.6);
}

TEST_F(InlayPocketsTest, ThereAreNoneInAWallThatIsTooThinEverywhere) {
  limits_.assign(limits_.size(), 0.2);
  EXPECT_EQ(inlayPockets(symbol_, 21, limits_, 0.6).depthMm, 0);
}

TEST(PaintedModules, AreTheDarkOnes) {
  const Symbol symbol = *encodeSymbol("HELLO", {.version = 1});
  const DepthField field = paintedModules(symbol, 21);
  for (int row = 0; row < field.size; ++row)
    for (int column = 0; column < field.size; ++column)
      ASSERT_EQ(field.depth(row, column) > 0, symbol.isDark(row / 5, column / 5));
}

}  // namespace
}  // namespace qrelief
