// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/one_light_2020.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>

#include "base/halton.h"
#include "math/angle.h"
#include "math/tolerance.h"
#include "study/methods/break_up.h"
#include "study/study_spots.h"

namespace qrelief::study {
namespace {

using OneLight2020 = PlateTest;

TEST_F(OneLight2020, GreyLevelsMatchTheFit) {
  EXPECT_EQ(oneLightGrey(1, 0), 77);   // 19.6 · 20.88^0.3441 + 21.24 = 77.0
  EXPECT_EQ(oneLightGrey(1, 1), 177);  // 19.6 · 417.6^0.3441 + 21.24 = 177.7
  EXPECT_EQ(oneLightGrey(0, 0), 21);
}

/// With the lamp on the left, a point is shaded if the rim, or a step further left, rises above it by more than their
/// distance times the tangent of the lamp's elevation.
TEST_F(OneLight2020, LoneModuleIsAsDeepAsItsShadowIsLong) {
  const StudyPlacement spot = plateSpot(2);
  const Symbol symbol = withOneDarkModule(spot);
  const SubmoduleMask mask = submodulesToCarve(symbol, ModulePattern::None, FinderPattern::None);
  const OneLightOptions options;
  const auto code = carveOneLight2020(spot, symbol, mask, options);
  ASSERT_TRUE(code.has_value());
  const double h = spot.submoduleMm(), stepMm = options.stepSubmodules * h;
  const double elevation = toRadians(options.upperElevationDeg);
  const int expected = oneLightGrey(1, std::sin(elevation)) - static_cast<int>(0.2 * 255);
  std::vector<double> depths;  // by column
  const auto litShare = [&](double depth) {
    int lit = 0;
    for (std::uint32_t point = 1; point <= kLampPoints; ++point) {
      const double x = (static_cast<double>(depths.size()) + halton23(point)[0]) * h;
      bool isShaded = false;
      for (std::size_t edge = 0; edge <= depths.size(); ++edge) {
        const double above = edge == 0 ? 0 : depths[edge - 1];
        isShaded = isShaded || depth - above > (x - static_cast<double>(edge) * h) * std::tan(elevation);
      }
      lit += !isShaded;
    }
    return static_cast<double>(lit) / kLampPoints;
  };
  while (depths.size() < kSubmodulesPerModule) {
    double depth = stepMm;
    while (oneLightGrey(1, litShare(depth) * std::sin(elevation)) > expected) depth += stepMm;
    depths.push_back(depth);
  }
  for (const std::uint32_t i : carvedOf(mask)) {
    const auto column = static_cast<std::size_t>(static_cast<int>(i) % mask.rows() % kSubmodulesPerModule);
    EXPECT_NEAR(code->depths.depthMm[i], depths[column], stepMm + kDepthQuantumMm) << "column " << column;
  }
  EXPECT_EQ(code->limited, 0u);
}

TEST_F(OneLight2020, RunsOfDataModulesAreBrokenUpWithinTheCorrection) {
  SymbolOptions options;
  options.version = 3;
  options.errorCorrection = ErrorCorrection::H;
  Symbol symbol = *encodeSymbol("https://example.org/p/1", options);
  const auto longRuns = [](const Symbol& s) {
    int count = 0;
    for (int row = 0; row < s.size; ++row)
      for (int column = 0, run = 0; column < s.size; ++column) {
        run = s.isDark(row, column) && s.role(row, column) == ModuleRole::Data ? run + 1 : 0;
        count += run == 4;
      }
    return count;
  };
  const int before = longRuns(symbol);
  ASSERT_GT(before, 0);
  breakUpRuns2020(symbol);
  EXPECT_LT(longRuns(symbol), before);
  EXPECT_LE(correctionReserve(symbol).spent, correctionReserve(symbol).correctable);
}

TEST_F(OneLight2020, LockDamagesOneBlockBeyondCorrection) {
  SymbolOptions options;
  options.version = 3;
  const Symbol symbol = *encodeSymbol("https://example.org/p/1", options);
  const std::vector<std::uint8_t> locked = lockedModules2020(symbol);
  EXPECT_EQ(std::count(locked.begin(), locked.end(), 1), correctionReserve(symbol).correctable + 1);
  for (std::size_t i = 0; i < locked.size(); ++i) EXPECT_FALSE(locked[i] && symbol.dark[i]);
}

}  // namespace
}  // namespace qrelief::study
