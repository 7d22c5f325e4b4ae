// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/printed_ink.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "support/symbols.h"

namespace qrelief {
namespace {

constexpr int kPixels = 400;

/// Returns the request for a square of n × n modules of which some are dark.
PrintedInkRequest requestOf(int modules, double moduleMm, const std::vector<int>& dark, Vec3 up = {0, 0, 1}) {
  PrintedInkRequest request;
  request.process = *processOf({});  // lines of 0.45 mm, layers of 0.2 mm
  request.symbol = lightSymbol(modules);
  for (const int module : dark) request.symbol.dark[module] = 1;
  request.symbolMm = modules * moduleMm;
  request.frame = makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 250);
  request.buildUp = up;
  return request;
}

struct Picture {
  BottomUp<float> shares;
  double pixelMm = 0;

  explicit Picture(const PrintedInkRequest& request) : pixelMm(request.symbolMm * 1.2 / kPixels) {
    shares = printedInk(request, {pixelMm, kPixels});
  }
  double at(Vec2 onPlane) const {
    const Vec2 pixel = onPlane / pixelMm + kPixels / 2.0;
    return static_cast<double>(shares.at(static_cast<int>(pixel.y), static_cast<int>(pixel.x)));
  }
  double areaMm2() const {
    double sum = 0;
    for (const float share : shares) sum += static_cast<double>(share);
    return sum * pixelMm * pixelMm;
  }
};

const Vec3 kPoses[] = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 1, 1}};  // facing up, upright twice, slanted

TEST(PrintedInk, KeepsWideModulesInEveryPose) {
  for (const Vec3 up : kPoses) {
    const Picture picture(requestOf(3, 4, {4}, up));
    EXPECT_NEAR(picture.areaMm2(), 16, 0.4) << up.x << up.y << up.z;
    EXPECT_NEAR(picture.at({0, 0}), 1, 1e-6);
    EXPECT_NEAR(picture.at({4, 0}), 0, 1e-6);
    EXPECT_NEAR(picture.at({1.9, 0}), 1, 0.2);
    EXPECT_NEAR(picture.at({2.1, 0}), 0, 0.2);
  }
}

TEST(PrintedInk, LosesRegionsOfEitherColourNarrowerThanALine) {
  for (const double moduleMm : {0.4, 0.5}) {
    const double expected = moduleMm < 0.45 ? 0 : 1;
    const Picture dark(requestOf(7, moduleMm, {24}));
    EXPECT_NEAR(dark.at({0, 0}), expected, 0.2) << moduleMm;
    std::vector<int> all;
    for (int k = 0; k < 49; ++k)
      if (k != 24) all.push_back(k);
    const Picture light(requestOf(7, moduleMm, all));
    EXPECT_NEAR(light.at({0, 0}), 1 - expected, 0.2) << moduleMm;
  }
}

TEST(PrintedInk, AStripedWallKeepsLayersButLosesNarrowColumns) {
  const double moduleMm = 0.4;  // two layers high, and narrower than a line
  std::vector<int> row, column;
  for (int k = 0; k < 11; ++k) row.push_back(5 * 11 + k), column.push_back(k * 11 + 5);
  EXPECT_NEAR(Picture(requestOf(11, moduleMm, row, {0, 1, 0})).at({0, 0}), 1, 0.1);
  EXPECT_NEAR(Picture(requestOf(11, moduleMm, column, {0, 1, 0})).at({0, 0}), 0, 0.1);
  EXPECT_NEAR(Picture(requestOf(11, moduleMm, column, {1, 0, 0})).at({0, 0}), 1, 0.1);  // lies along the layers
}

TEST(PrintedInk, OnAWallHeightsAreWholeLayers) {
  // A stripe from -0.55 to 0.55 mm: layers have their middles at odd multiples of 0.1 mm, and six lie inside.
  PrintedInkRequest request = requestOf(3, 1.1, {3, 4, 5}, {0, 1, 0});
  request.bedMm = 0;
  const Picture picture(request);
  double height = 0;
  for (int k = 0; k < 2000; ++k) height += picture.at({0, -1 + k / 1000.0}) / 1000;
  EXPECT_NEAR(height, 6 * 0.2, 0.02);
}

TEST(PrintedInk, OutlinesAroundTheSymbolArePrintedTooUnlessNarrowerThanALine) {
  const auto bar = [](double left, double right) { return Ring{{left, -1}, {right, -1}, {right, 1}, {left, 1}}; };
  for (const Vec3 up : kPoses) {
    PrintedInkRequest request = requestOf(1, 2, {0}, up);
    request.symbolMm = 2;
    request.around = {bar(3, 4), bar(-4, -3)};
    const double pixelMm = 10.0 / kPixels;
    const BottomUp<float> shares = printedInk(request, {pixelMm, kPixels});
    const auto at = [&](double x, double y) {
      const Vec2 pixel = Vec2(x, y) / pixelMm + kPixels / 2.0;
      return static_cast<double>(shares.at(static_cast<int>(pixel.y), static_cast<int>(pixel.x)));
    };
    for (const double x : {0.0, 3.5, -3.5}) EXPECT_NEAR(at(x, 0), 1, 0.01) << x << up.x << up.y << up.z;
    for (const double x : {2.0, -2.0, 4.8}) EXPECT_NEAR(at(x, 0), 0, 0.01) << x << up.x << up.y << up.z;
  }
  PrintedInkRequest thin = requestOf(1, 2, {0});
  thin.around = {bar(3, 3.3)};  // lines are 0.45 mm wide
  EXPECT_NEAR(printedInk(thin, {10.0 / kPixels, kPixels}).at(kPixels / 2, kPixels / 2 + 126), 0, 0.05);
}

TEST(PrintedInk, ColoursBleedAcrossTheBorder) {
  const PrintedInkRequest request = requestOf(3, 4, {4});
  const Picture picture(request);
  const double sigma = kBleedLines * 0.45;
  for (const double off : {-0.1, 0.0, 0.1})
    EXPECT_NEAR(picture.at({2 + off, 0}), std::erfc(off / sigma / std::sqrt(2)) / 2, 0.12) << off;
  EXPECT_NEAR(picture.at({2 + 4 * sigma, 0}), 0, 0.01);
}

}  // namespace
}  // namespace qrelief
