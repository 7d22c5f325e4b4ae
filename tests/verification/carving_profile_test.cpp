// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/carving_profile.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

#include "qr/module_pattern.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr double kModuleMm = 1.2;
constexpr int kN = kSubmodulesPerModule;

class CarvingProfileTest : public testing::Test {
 protected:
  void SetUp() override {
    symbol_ = *encodeSymbol("QRELIEF", {.version = 1});
    symbolMm_ = kModuleMm * symbol_.size;
    // The eye is far away, so the plate's walls are vertical.
    frame_ = makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 10000);
  }

  /// Returns a plate of 29 × 29 modules, `depth` deep where the module at (row, column) of the picture is dark. In a
  /// dark module the middle 3 × 3 submodules are floor; the walls lean over the next ones.
  template <class IsDark, class Base>
  Mesh plate(double depth, const IsDark& isDark, const Base& base) const {
    const int modules = symbol_.size + 2 * kQuietZoneModules, cells = kN * modules;
    const double edge = kModuleMm * modules;
    return shapes::plate({edge, edge}, 20, cells, cells, [&](double x, double y) {
      const int i = static_cast<int>(std::lround((x + edge / 2) / kModuleMm * kN));
      const int j = static_cast<int>(std::lround((edge / 2 - y) / kModuleMm * kN));
      const int column = i / kN - kQuietZoneModules, row = j / kN - kQuietZoneModules;
      const bool inside = row >= 0 && column >= 0 && row < symbol_.size && column < symbol_.size;
      const bool middle = i % kN != 0 && j % kN != 0;
      return base(x, y) - (inside && middle && isDark(row, column) ? depth : 0);
    });
  }
  Mesh plate(double depth) const {
    return plate(
        depth, [&](int r, int c) { return symbol_.isDark(r, c); }, [](double, double) { return 0; });
  }
  CarvingProfile profile(const Mesh& mesh) const {
    const RayTree tree(mesh);
    return profileCarving(tree, frame_, symbol_, symbolMm_);
  }

  Symbol symbol_;
  ProjectionFrame frame_;
  double symbolMm_ = 0;
};

TEST_F(CarvingProfileTest, MeasuresTheDepthOfAPlateAndFindsTheFloors) {
  const CarvingProfile result = profile(plate(0.5));
  EXPECT_EQ(result.pose, SymbolPose::AsWanted);
  EXPECT_GT(result.fit, 0.9);
  // The middles of the floors are 0.5 deep, of the leaning walls 0.25, and of the corners about 0.125.
  const int edge = kN * symbol_.size;
  for (int row = 0; row < symbol_.size; ++row)
    for (int column = 0; column < symbol_.size; ++column) {
      const auto middle = static_cast<std::size_t>((kN * row + 2) * edge + kN * column + 2);
      EXPECT_EQ(result.carved[middle], symbol_.isDark(row, column));
      EXPECT_NEAR(result.depthMm[middle], symbol_.isDark(row, column) ? 0.5 : 0, 1e-3);
    }
}

TEST_F(CarvingProfileTest, RaisedModulesHaveNegativeDepth) {
  const CarvingProfile result = profile(plate(-0.5));
  EXPECT_EQ(result.pose, SymbolPose::AsWanted);
  EXPECT_NEAR(result.meanDepthMm, -0.35, 0.01);  // floors -0.5, the leaning walls around them half that or less
}

TEST_F(CarvingProfileTest, RecognisesTheMirrorImageFromEverySide) {
  const int last = symbol_.size - 1;
  const auto flat = [](double, double) { return 0; };
  EXPECT_EQ(profile(plate(
                        0.5, [&](int r, int c) { return symbol_.isDark(r, last - c); }, flat))
                .pose,
            SymbolPose::Mirrored);
  EXPECT_EQ(profile(plate(
                        0.5, [&](int r, int c) { return symbol_.isDark(last - r, c); }, flat))
                .pose,
            SymbolPose::Mirrored);
  EXPECT_EQ(profile(plate(
                        0.5, [&](int r, int c) { return symbol_.isDark(c, r); }, flat))
                .pose,
            SymbolPose::Mirrored);
}

TEST_F(CarvingProfileTest, MeasuresTheAnticlockwiseTurnOfTheSymbol) {
  const int last = symbol_.size - 1;
  const auto flat = [](double, double) { return 0; };
  // After a quarter turn anticlockwise, the top right corner is at the top left.
  EXPECT_EQ(profile(plate(
                        0.5, [&](int r, int c) { return symbol_.isDark(c, last - r); }, flat))
                .pose,
            SymbolPose::Turned90);
  EXPECT_EQ(profile(plate(
                        0.5, [&](int r, int c) { return symbol_.isDark(last - r, last - c); }, flat))
                .pose,
            SymbolPose::Turned180);
  EXPECT_EQ(profile(plate(
                        0.5, [&](int r, int c) { return symbol_.isDark(last - c, r); }, flat))
                .pose,
            SymbolPose::Turned270);
}

TEST_F(CarvingProfileTest, DetectsAShallowCarvingOnACurvedSurface) {
  const auto dome = [](double x, double y) { return std::sqrt(60 * 60 - x * x - y * y) - 60 + 0.3 * std::sin(x / 3); };
  const CarvingProfile result = profile(plate(
      0.2, [&](int r, int c) { return symbol_.isDark(r, c); }, dome));
  EXPECT_EQ(result.pose, SymbolPose::AsWanted);
  double sum = 0;
  int count = 0;
  for (int row = 0; row < symbol_.size; ++row)
    for (int column = 0; column < symbol_.size; ++column) {
      if (!symbol_.isDark(row, column)) continue;
      sum += result.depthMm.at(kN * row + 2, kN * column + 2);
      ++count;
    }
  EXPECT_NEAR(sum / count, 0.2, 0.01);
}

TEST_F(CarvingProfileTest, FindsNothingOnAPlainPlateOrWithAnotherText) {
  EXPECT_EQ(profile(plate(0)).pose, SymbolPose::None);
  const Symbol other = *encodeSymbol("SOMETHING", {.version = 1});
  const CarvingProfile result = profile(plate(
      0.5, [&](int r, int c) { return other.isDark(r, c); }, [](double, double) { return 0; }));
  EXPECT_EQ(result.pose, SymbolPose::None);
  EXPECT_TRUE(result.depthMm.empty());
}

}  // namespace
}  // namespace qrelief
