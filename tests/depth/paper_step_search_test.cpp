// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth/paper_step_search.h"

#include <cmath>
#include <gtest/gtest.h>

#include "math/tolerance.h"
#include "support/symbols.h"

namespace qrelief {
namespace {

TEST(DepthIncrease, MatchesThePapersFormula) {
  EXPECT_NEAR(depthIncrease(0), 0.0932, 5e-5);
  EXPECT_NEAR(depthIncrease(1), 0.1, 1e-12);
  EXPECT_NEAR(depthIncrease(5), 0.389, 5e-4);
  EXPECT_NEAR(depthIncrease(1000), 0.689, 5e-4);
}

/// Fixture with a symbol of `size` modules in which only the given modules are dark.
class PaperStepSearchTest : public testing::Test {
 protected:
  void darken(int row, int column) {
    symbol_.dark.at(row, column) = 1;
    for (int k = 0; k < 25; ++k) mask_.at(row * 5 + k / 5, column * 5 + k % 5) = 1;
  }
  PaperStepSearch start(double limit = 5, DepthSearchOptions options = {}) {
    return {CarvingTarget{&symbol_, &mask_, 21, std::vector<double>(105 * 105, limit)}, options};
  }
  /// Returns luminances: 1 on light modules, `carved(depth)` on carved submodules.
  template <class Function>
  Grid<double> luminances(const PaperStepSearch& search, Function carved) {
    const int edge = 5 * 29;
    Grid<double> all(edge, edge, 1);
    for (int row = 0; row < 105; ++row)
      for (int column = 0; column < 105; ++column)
        if (mask_.at(row, column))
          all.at(row + 20, column + 20) = carved(row, column, search.depths().depth(row, column));
    return all;
  }
  Symbol symbol_ = lightSymbol(21);
  SubmoduleMask mask_{105, 105};
};

TEST_F(PaperStepSearchTest, EveryCarvedSubmoduleStartsAtOneLayerAndLightOnesStayUncarved) {
  darken(10, 10);
  const PaperStepSearch search = start();
  for (int row = 0; row < 105; ++row)
    for (int column = 0; column < 105; ++column)
      EXPECT_DOUBLE_EQ(search.depths().depth(row, column), mask_.at(row, column) ? 0.1 : 0);
}

TEST_F(PaperStepSearchTest, StopsOnceEverySubmoduleIsDarkEnough) {
  darken(10, 10);
  PaperStepSearch search = start(5, {.contrast = 0.3});
  // Luminance falls linearly with depth and reaches 0.7 at 0.6 mm.
  while (!search.finished()) search.update(luminances(search, [](int, int, double depth) { return 1 - 0.5 * depth; }));
  for (const double depth : search.depths().depthMm) {
    if (depth == 0) continue;
    EXPECT_GE(depth, 0.6 - 1e-9);
    EXPECT_LE(depth, 0.6 + 0.1 + 1e-9);  // overshoots by at most one step
  }
  EXPECT_EQ(search.limitedCount(), 0u);
  EXPECT_LE(search.worstExcess(), 0);
}

TEST_F(PaperStepSearchTest, JudgesEverySubmoduleSeparately) {
  darken(10, 10);
  PaperStepSearch search = start();
  while (!search.finished())
    search.update(
        luminances(search, [](int row, int, double depth) { return 1 - (row % 5 == 0 ? 2.0 : 0.5) * depth; }));
  EXPECT_LT(search.depths().depth(50, 50), 0.3);
  EXPECT_GE(search.depths().depth(52, 50), 0.6 - 1e-9);
}

/// Returns a submodule's depths over some passes in which each step changes its luminance by `change`.
std::vector<double> depthsOver(PaperStepSearch search, int passes, std::size_t submodule, double change) {
  std::vector<double> depths;
  for (int pass = 0; pass < passes; ++pass) {
    search.update(Grid<double>(145, 145, 1 - change * pass));
    depths.push_back(search.depths().depthMm[submodule]);
  }
  return depths;
}

TEST_F(PaperStepSearchTest, StepsGrowOnlyWhereLuminanceStaysTheSame) {
  darken(10, 10);
  const std::size_t middle = 52 * 105 + 52;
  const DepthSearchOptions options{.contrast = 0.9, .significantChange = 0.02, .roundSteps = false};
  const auto at = [&](ChangeSince since, double change) {
    DepthSearchOptions of = options;
    of.changeSince = since;
    return depthsOver(start(5, of), 4, middle, change).back() - 0.1;
  };
  const double slow = 4 * depthIncrease(0);
  const double fast = depthIncrease(0) + depthIncrease(1) + depthIncrease(2) + depthIncrease(3);
  EXPECT_NEAR(at(ChangeSince::LastIteration, 0.03), slow, kDepthQuantumMm);
  EXPECT_NEAR(at(ChangeSince::LastIteration, 0.01), fast, kDepthQuantumMm);
  EXPECT_NEAR(at(ChangeSince::LastChange, 0.001), fast, kDepthQuantumMm);
  // Two small changes are a significant one.
  EXPECT_NEAR(at(ChangeSince::LastChange, 0.012), 2 * (depthIncrease(0) + depthIncrease(1)), kDepthQuantumMm);
}

TEST_F(PaperStepSearchTest, NeverExceedsALimitAndCountsIt) {
  darken(10, 10);
  PaperStepSearch search = start(0.333);
  while (!search.finished()) search.update(luminances(search, [](int, int, double) { return 0.95; }));
  for (const double depth : search.depths().depthMm) EXPECT_LE(depth, 0.333);
  EXPECT_NEAR(search.depths().depth(52, 52), 0.33, 1e-12);  // on the depth grid
  EXPECT_EQ(search.limitedCount(), 25u);
  EXPECT_NEAR(search.worstExcess(), 0.25, 1e-12);
}

TEST_F(PaperStepSearchTest, CountsSubmodulesThatTheLastPassLeavesTooBright) {
  darken(10, 10);
  PaperStepSearch search = start(5, {.maxIterations = 3});
  while (!search.finished()) {
    EXPECT_EQ(search.unfinishedCount(), 0u);
    search.update(luminances(search, [](int, int, double) { return 0.95; }));
  }
  EXPECT_EQ(search.iterations(), 3);
  EXPECT_EQ(search.unfinishedCount(), 25u);
  EXPECT_EQ(search.limitedCount(), 25u);
}

TEST_F(PaperStepSearchTest, TakesLargerStepsWhileTheLuminanceStalls) {
  darken(10, 10);
  PaperStepSearch search = start(1000);
  std::vector<double> depths;
  for (int i = 0; i < 12; ++i) {
    search.update(luminances(search, [](int, int, double) { return 0.9; }));
    depths.push_back(search.depths().depth(52, 52));
  }
  EXPECT_NEAR(depths[1] - depths[0], depthIncrease(1), kDepthQuantumMm);
  EXPECT_NEAR(depths[6] - depths[5], depthIncrease(6), kDepthQuantumMm);
}

TEST_F(PaperStepSearchTest, TheSurroundingsAreTheFourDarkestLightNeighbours) {
  darken(10, 10);
  PaperStepSearch search = start(5, {.contrast = 0.3});
  const int edge = 5 * 29;
  Grid<double> all(edge, edge, 1);
  const auto setModule = [&](int row, int column, double value) {
    for (int k = 0; k < 25; ++k) all.at((row + 4) * 5 + k / 5, (column + 4) * 5 + k % 5) = value;
  };
  // Four shaded neighbours have luminance 0.5, so the threshold is 0.35, not the 0.7 that bright neighbours would give.
  for (const auto& [row, column] : {std::pair(9, 9), std::pair(9, 10), std::pair(9, 11), std::pair(10, 9)})
    setModule(row, column, 0.5);
  setModule(10, 10, 0.4);
  search.update(all);
  EXPECT_NEAR(search.worstExcess(), 0.05, 1e-12);
}

TEST_F(PaperStepSearchTest, WidensTheRingInLargeDarkAreasUntilItHasFourLightModules) {
  for (int row = 0; row < 21; ++row)
    for (int column = 0; column < 21; ++column) darken(row, column);
  symbol_.dark.at(3, 3) = 0;  // one light module at distance 7 from (10, 10); the quiet zone is at distance 11
  for (int k = 0; k < 25; ++k) mask_.at(15 + k / 5, 15 + k % 5) = 0;
  PaperStepSearch search = start(5, {.contrast = 0.5});
  const int edge = 5 * 29;
  Grid<double> all(edge, edge);
  const auto setModule = [&](int row, int column, double value) {
    for (int k = 0; k < 25; ++k) all.at((row + 4) * 5 + k / 5, (column + 4) * 5 + k % 5) = value;
  };
  setModule(3, 3, 0.6);
  for (int i = -4; i < 25; ++i)
    for (int j = -4; j < 25; ++j)
      if (i < 0 || j < 0 || i > 20 || j > 20) setModule(i, j, 1.0);
  setModule(10, 10, 0.5);
  search.update(all);
  // The four darkest of {0.6, and the quiet zone's 1.0 …} give AL = 0.9 and threshold 0.45.
  EXPECT_NEAR(search.worstExcess(), 0.05, 1e-12);
}

TEST_F(PaperStepSearchTest, EndsAfterTheGivenNumberOfIterations) {
  darken(10, 10);
  PaperStepSearch search = start(1e6, {.maxIterations = 7});
  int updates = 0;
  while (!search.finished()) {
    search.update(luminances(search, [](int, int, double) { return 1.0; }));
    ++updates;
  }
  EXPECT_EQ(updates, 7);
}

}  // namespace
}  // namespace qrelief
