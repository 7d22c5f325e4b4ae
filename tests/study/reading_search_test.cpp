// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/reading_search.h"

#include <cmath>
#include <gtest/gtest.h>

#include "math/tolerance.h"
#include "support/symbols.h"

namespace qrelief::study {
namespace {

constexpr int kModules = 21;
constexpr int kEdge = 5 * kModules;
constexpr int kMapEdge = kEdge + 2 * 5 * kQuietZoneModules;

/// Fixture with a symbol of 21 modules of 1 mm in which only the given modules are dark; a closed form gives the light.
class ReadingSearchTest : public testing::Test {
 protected:
  /// @param from, to  range within the five submodules along each edge
  void darken(int row, int column, int from = 0, int to = 5) {
    symbol_.dark.at(row, column) = 1;
    for (int r = from; r < to; ++r)
      for (int c = from; c < to; ++c) mask_.at(row * 5 + r, column * 5 + c) = 1;
  }
  ReadingSearch start(const ReadingOptions& options, double limit = 5) {
    return {CarvingTarget{&symbol_, &mask_, kModules, std::vector<double>(kEdge * kEdge, limit)}, options};
  }
  /// Returns the light of a pit as wide as a module, r² / (r² + d²), regardless of its neighbours; 1 where nothing
  /// is carved.
  static double light(double depth) { return 0.25 / (0.25 + depth * depth); }
  void run(ReadingSearch& search) {
    while (!search.finished()) {
      Grid<double> map(kMapEdge, kMapEdge, 1);
      for (int row = 0; row < kEdge; ++row)
        for (int column = 0; column < kEdge; ++column)
          map.at(row + 20, column + 20) = light(search.depths().depth(row, column));
      search.update(map);
    }
  }
  double contrast(const ReadingSearch& search, int row, int column) {
    return search.contrasts()[static_cast<std::size_t>(row * kModules + column)];
  }
  Symbol symbol_ = lightSymbol(kModules);
  SubmoduleMask mask_{kEdge, kEdge};
};

TEST_F(ReadingSearchTest, MatchesTheClosedFormWithoutBlur) {
  darken(10, 10);
  ReadingSearch search = start({.dataContrast = 0.4, .blurModules = 0.01});
  run(search);
  // 1 - 0.25 / (0.25 + d²) = 0.4
  const double expected = 0.5 * std::sqrt(0.4 / 0.6);
  const double slack = 0.005 / (0.6 * 2 * expected / (0.25 + expected * expected)) + kDepthQuantumMm;
  EXPECT_GE(search.depths().depth(52, 52), expected - 1e-9);
  EXPECT_LE(search.depths().depth(52, 52), expected + slack);
  EXPECT_LE(search.iterations(), 8);
  EXPECT_EQ(search.doneFraction(), 1);
}

TEST_F(ReadingSearchTest, CarvesDeeperIfThePatternCoversLessOfAModule) {
  darken(5, 5);
  darken(5, 15, 1, 4);
  ReadingSearch search = start({.dataContrast = 0.2});
  run(search);
  EXPECT_NEAR(contrast(search, 5, 5), 0.2, 0.01);
  EXPECT_NEAR(contrast(search, 5, 15), 0.2, 0.01);
  EXPECT_GT(search.depths().depth(27, 77), 1.1 * search.depths().depth(27, 27));
}

TEST_F(ReadingSearchTest, CarvesModulesAmongDarkOnesLessDeep) {
  darken(3, 3);
  for (int row = 12; row < 15; ++row)
    for (int column = 12; column < 15; ++column) darken(row, column);
  ReadingSearch search = start({.dataContrast = 0.2, .blurModules = 0.6});
  run(search);
  EXPECT_LT(search.depths().depth(67, 67), search.depths().depth(17, 17));
  EXPECT_NEAR(contrast(search, 13, 13), 0.2, 0.02);
}

TEST_F(ReadingSearchTest, FinderPatternsHaveTheirOwnContrast) {
  darken(3, 3);
  symbol_.roles[3 * kModules + 3] = ModuleRole::Finder;
  darken(15, 15);
  ReadingSearch search = start({.dataContrast = 0.1, .finderContrast = 0.35});
  run(search);
  EXPECT_NEAR(contrast(search, 3, 3), 0.35, 0.01);
  EXPECT_NEAR(contrast(search, 15, 15), 0.1, 0.01);
}

TEST_F(ReadingSearchTest, StopsAtTheLimitAndCountsIt) {
  darken(10, 10, 1, 4);
  ReadingSearch search = start({.dataContrast = 0.3}, 0.123);
  run(search);
  EXPECT_DOUBLE_EQ(search.depths().depth(52, 52), 0.12);
  EXPECT_EQ(search.limitedCount(), 9u);
  EXPECT_EQ(search.doneFraction(), 1);
}

TEST_F(ReadingSearchTest, LightModulesStayUncarved) {
  darken(10, 10, 1, 4);
  ReadingSearch search = start({});
  run(search);
  for (int row = 0; row < kEdge; ++row)
    for (int column = 0; column < kEdge; ++column)
      EXPECT_EQ(search.depths().depth(row, column) > 0, mask_.at(row, column));
}

}  // namespace
}  // namespace qrelief::study
