// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth/one_light_search.h"

#include <cmath>
#include <gtest/gtest.h>

#include "depth/light_neighbours.h"
#include "math/angle.h"
#include "math/tolerance.h"
#include "support/symbols.h"

namespace qrelief {
namespace {

constexpr int kModules = 21;
constexpr int kEdge = kSubmodulesPerModule * kModules;
constexpr int kQuiet = kSubmodulesPerModule * kQuietZoneModules;
constexpr double kSubmoduleMm = 0.2;  // modules of 1 mm
constexpr double kContrast = 0.3;

/// Fixture with a symbol on a plane in which only the given modules are dark; brute force finds the light.
class OneLightSearchTest : public testing::Test {
 protected:
  OneLightSearchTest() {}
  void darken(int row, int column) { symbol_.dark.at(row, column) = 1; }

  OneLightSearch start(ModulePattern pattern, double limitMm = 5) {
    mask_ = submodulesToCarve(symbol_, pattern, FinderPattern::AsModules);
    return {CarvingTarget{&symbol_, &mask_, kModules, std::vector<double>(mask_.size(), limitMm)},
            {.lamp = lamp_, .contrast = kContrast}};
  }

  double lampLight(double elevationDeg) const { return lamp_.strength * std::sin(toRadians(elevationDeg)); }
  /// Returns the depth that each further submodule of a run adds.
  double stepMm() const {
    return kSubmoduleMm * shadowFraction(kContrast, lampLight(lamp_.elevationDeg)) *
           std::tan(toRadians(lamp_.elevationDeg));
  }

  /// Returns true if something hides the lamp from the point (x, y) of the symbol, in submodules.
  bool isInShadow(const DepthField& field, double x, double y) const {
    const double azimuth = toRadians(lamp_.azimuthDeg), rise = kSubmoduleMm * std::tan(toRadians(surfaceElevationDeg_));
    const auto depthAt = [&](double u, double v) {
      const int c = static_cast<int>(std::floor(u)), r = static_cast<int>(std::floor(v));
      return c < 0 || r < 0 || c >= kEdge || r >= kEdge ? 0 : field.depth(r, c);
    };
    const double depth = depthAt(x, y);
    for (double t = 0; t * rise < depth; t += 0.01)
      if (depthAt(x + t * std::cos(azimuth), y - t * std::sin(azimuth)) < depth - t * rise - 1e-9) return true;
    return false;
  }

  /// Returns the luminance of every submodule. Uncarved surface sees the lamp at `surfaceElevationDeg_`.
  Grid<double> luminances(const DepthField& field) const {
    constexpr int kPlaces = 8;
    const int edge = kEdge + 2 * kQuiet;
    const double open = 1 + lampLight(lamp_.elevationDeg), lamp = lampLight(surfaceElevationDeg_);
    Grid<double> all(edge, edge, (1 + lamp) / open);
    for (int row = 0; row < kEdge; ++row)
      for (int column = 0; column < kEdge; ++column) {
        if (field.depth(row, column) == 0) continue;
        double lit = 0;
        for (int k = 0; k < kPlaces * kPlaces; ++k)
          lit += !isInShadow(field, column + (k % kPlaces + 0.5) / kPlaces, row + (k / kPlaces + 0.5) / kPlaces);
        all.at(row + kQuiet, column + kQuiet) = (1 + reflected_ + lamp * lit / (kPlaces * kPlaces)) / open;
      }
    return all;
  }

  void run(OneLightSearch& search) const {
    while (!search.finished()) search.update(luminances(search.depths()));
  }

  /// Returns the number of carved submodules brighter than the target, if all surroundings are open.
  int tooBright(const DepthField& field, double tolerance = 0) const {
    const Grid<double> all = luminances(field);
    int count = 0;
    for (int row = 0; row < kEdge; ++row)
      for (int column = 0; column < kEdge; ++column)
        count += field.depth(row, column) > 0 && luminanceOf(all, row, column) > (1 - kContrast + tolerance) * all[0];
    return count;
  }

  DirectionalLight lamp_{.azimuthDeg = 90, .elevationDeg = 30, .strength = 19};
  double surfaceElevationDeg_ = 30;
  double reflected_ = 0;
  Symbol symbol_ = lightSymbol(kModules);
  SubmoduleMask mask_;
};

TEST_F(OneLightSearchTest, ALoneModuleBeginsAsAStaircaseWithTheSlopeOfTheClosedForm) {
  darken(10, 10);
  for (const auto& [azimuth, isRow, isMirrored] :
       {std::tuple{90, true, false}, {270, true, true}, {180, false, false}, {0, false, true}}) {
    lamp_.azimuthDeg = azimuth;
    for (const double elevation : {20.0, 30.0, 45.0}) {
      lamp_.elevationDeg = elevation;
      const OneLightSearch search = start(ModulePattern::None);
      for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 5; ++column) {
          const int along = isRow ? row : column, k = isMirrored ? 4 - along : along;
          const double depth = search.depths().depth(50 + row, 50 + column);
          EXPECT_GE(depth, (k + 1) * stepMm() - 1e-9) << azimuth << "°, " << row << ", " << column;
          EXPECT_LE(depth, (k + 1) * (stepMm() + kDepthQuantumMm));
        }
      EXPECT_NEAR(search.depths().depth(52, 52), 0.6 * shadowDepth(kContrast, lamp_), 3 * kDepthQuantumMm);
    }
  }
}

TEST_F(OneLightSearchTest, AnUncarvedSubmoduleStartsANewRun) {
  for (int row = 3; row < 18; ++row) darken(row, 10);
  const DepthField joined = start(ModulePattern::None).depths(), apart = start(ModulePattern::Square).depths();
  EXPECT_NEAR(joined.depth(5 * 18 - 1, 52), 75 * stepMm(), 75 * kDepthQuantumMm);
  EXPECT_GE(joined.depth(5 * 18 - 1, 52), 75 * stepMm() - 1e-9);
  for (int row = 3; row < 18; ++row) EXPECT_NEAR(apart.depth(5 * row + 3, 52), 3 * stepMm(), 3 * kDepthQuantumMm);
}

TEST_F(OneLightSearchTest, TheClosedFormIsTheShallowestDarkEnoughDepthWithoutReflections) {
  for (int row = 4; row < 8; ++row)
    for (int column = 5; column < 9; ++column) darken(row, column);
  darken(12, 3);
  for (const double azimuth : {90.0, 35.0, 200.0}) {
    lamp_.azimuthDeg = azimuth;
    OneLightSearch search = start(ModulePattern::ThickPlus);
    run(search);
    EXPECT_EQ(tooBright(search.depths(), 1e-9), 0) << azimuth;
    DepthField less = search.depths();
    int carved = 0;
    for (double& depth : less.depthMm) carved += depth > 0, depth = std::max(0.0, 0.6 * depth);
    EXPECT_GT(tooBright(less), 0.9 * carved) << azimuth;
  }
}

TEST_F(OneLightSearchTest, DeepensModulesThatReflectionsBrightenUntilTheyAreDarkEnough) {
  darken(10, 10);
  darken(3, 4);
  reflected_ = 1;
  OneLightSearch search = start(ModulePattern::None);
  const DepthField first = search.depths();
  EXPECT_GT(tooBright(first), 0);
  run(search);
  EXPECT_EQ(tooBright(search.depths()), 0);
  // (1 + 1 + 9.5·(1 − f)) ≤ 0.7·10.5 requires f ≥ 0.44 instead of 0.33: two fifths more.
  for (std::size_t i = 0; i < first.depthMm.size(); ++i)
    EXPECT_LE(search.depths().depthMm[i], 1.5 * first.depthMm[i] + 5 * kDepthQuantumMm);
  EXPECT_EQ(search.limitedCount(), 0u);
  EXPECT_EQ(search.doneFraction(), 1);
}

TEST_F(OneLightSearchTest, StartsDeeperWhereTheSurfaceFacesTheLamp) {
  darken(10, 10);
  surfaceElevationDeg_ = 45;
  OneLightSearch search = start(ModulePattern::None);
  const double before = search.depths().depth(54, 52);
  run(search);
  EXPECT_NEAR(search.depths().depth(54, 52),
              kSubmoduleMm * 5 * shadowFraction(kContrast, lampLight(45)) * std::tan(toRadians(45)),
              5 * kDepthQuantumMm);
  EXPECT_GT(search.depths().depth(54, 52), 1.5 * before);
}

TEST_F(OneLightSearchTest, CarvesNothingDeepWhereTheLampDoesNotReach) {
  darken(10, 10);
  surfaceElevationDeg_ = 0;
  OneLightSearch search = start(ModulePattern::None);
  run(search);
  EXPECT_EQ(search.depths().depth(52, 52), kDepthQuantumMm);
  EXPECT_EQ(search.limitedCount(), 25u);
}

TEST_F(OneLightSearchTest, StopsAtTheLimitAndCountsSubmodulesThatStayTooBright) {
  darken(10, 10);
  OneLightSearch search = start(ModulePattern::None, 0.055);
  run(search);
  for (const double depth : search.depths().depthMm) EXPECT_LE(depth, 0.05 + 1e-9);
  EXPECT_EQ(search.limitedCount(), static_cast<std::size_t>(tooBright(search.depths())));
  EXPECT_GT(search.limitedCount(), 0u);
}

TEST(ShadowFraction, FollowsFromTheSkysShareOfTheLight) {
  EXPECT_DOUBLE_EQ(shadowFraction(0.3, 9), 1.0 / 3);
  EXPECT_EQ(shadowFraction(0.5, 0.5), 1);  // the sky alone is too bright
  EXPECT_EQ(shadowFraction(0.3, 0), 1);
  EXPECT_EQ(shadowFraction(0.3, -1), 1);
}

}  // namespace
}  // namespace qrelief
