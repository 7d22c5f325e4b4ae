// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth/fast_search.h"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>

#include "depth/light_neighbours.h"
#include "depth/paper_step_search.h"
#include "support/pocket_light.h"

namespace qrelief {
namespace {

constexpr double kContrast = 0.3;

/// Fixture with a real symbol on a made-up surface. PocketSky with interreflection gives the light; each submodule is
/// up to a twentieth brighter or darker than that.
class FastSearchTest : public testing::Test {
 protected:
  FastSearchTest()
      : symbol_(*encodeSymbol("https://qrelief.example", {})),
        mask_(submodulesToCarve(symbol_, ModulePattern::Square, FinderPattern::ThickPlus)),
        sky_(mask_, kSymbolMm / mask_.rows()) {}

  static constexpr double kSymbolMm = 25;

  CarvingTarget target(double limitMm) const {
    return {&symbol_, &mask_, kSymbolMm, std::vector<double>(mask_.size(), limitMm)};
  }

  Grid<double> luminances(const DepthField& field) const {
    return pocketLuminances(sky_, field,
                            [](int row, int column) { return 1 + 0.05 * std::sin(7.0 * row + 3.0 * column); });
  }

  /// @returns the total number of submodule measurements
  std::size_t run(DepthSolver& solver) const {
    std::size_t measured = 0;
    while (!solver.finished()) {
      measured += solver.due().empty() ? sky_.carved().size() : solver.due().size();
      solver.update(luminances(solver.depths()));
    }
    return measured;
  }

  /// Returns the number of submodules with G > 0, if all light modules have luminance 1.
  int tooBright(const DepthField& field) const {
    const Grid<double> all = luminances(field);
    int count = 0;
    for (const std::uint32_t i : sky_.carved())
      count += luminanceOf(all, static_cast<int>(i) / mask_.rows(), static_cast<int>(i) % mask_.rows()) > 1 - kContrast;
    return count;
  }

  double meanMm(const DepthField& field) const {
    double sum = 0;
    for (const double depth : field.depthMm) sum += depth;
    return sum / static_cast<double>(sky_.carved().size());
  }

  Symbol symbol_;
  SubmoduleMask mask_;
  PocketSky sky_;
};

TEST_F(FastSearchTest, ReachesThePapersGoalWithHalfTheMeasurementsAndNoMoreDepth) {
  FastSearch fast(target(5), {.contrast = kContrast});
  PaperStepSearch paper(target(5), {.contrast = kContrast});
  const std::size_t measured = run(fast), measuredByPaper = run(paper);
  EXPECT_EQ(tooBright(fast.depths()), 0);
  EXPECT_EQ(tooBright(paper.depths()), 0);
  EXPECT_LT(fast.iterations(), paper.iterations());
  EXPECT_LE(2 * measured, measuredByPaper);
  EXPECT_LE(meanMm(fast.depths()), meanMm(paper.depths()));
  EXPECT_EQ(fast.limitedCount(), 0u);
}

TEST_F(FastSearchTest, AHigherTargetDeepensItsOwnModuleAndHardlyAnyOther) {
  FastSearchOptions options{.contrast = kContrast};
  options.contrastOfModule.assign(symbol_.dark.size(), kContrast);
  const auto isAsked = [&](int row, int column) { return (row / 5 + column / 5) % 2 == 0; };  // a chessboard of modules
  for (int row = 0; row < symbol_.size; ++row)
    for (int column = 0; column < symbol_.size; ++column)
      if (isAsked(5 * row, 5 * column))
        options.contrastOfModule[static_cast<std::size_t>(row * symbol_.size + column)] = 0.45;
  FastSearch uneven(target(5), options), even(target(5), {.contrast = kContrast});
  run(uneven);
  run(even);
  const Grid<double> all = luminances(uneven.depths());
  double asked = 0, askedBefore = 0, others = 0, othersBefore = 0;
  for (const std::uint32_t i : sky_.carved()) {
    const int row = static_cast<int>(i) / mask_.rows(), column = static_cast<int>(i) % mask_.rows();
    EXPECT_LE(luminanceOf(all, row, column), 1 - (isAsked(row, column) ? 0.45 : kContrast));
    (isAsked(row, column) ? asked : others) += uneven.depths().depthMm[i];
    (isAsked(row, column) ? askedBefore : othersBefore) += even.depths().depthMm[i];
  }
  EXPECT_GT(asked, 1.3 * askedBefore);
  EXPECT_LT(others, 1.15 * othersBefore);
}

TEST_F(FastSearchTest, StartingFromAnEarlierResultNeedsFewerMeasurementsAndNoMoreDepth) {
  FastSearchOptions options{.contrast = kContrast};
  options.contrastOfModule.assign(symbol_.dark.size(), kContrast);
  for (std::size_t module = 0; module < symbol_.dark.size(); module += 3) options.contrastOfModule[module] = 0.33;
  FastSearch before(target(5), {.contrast = kContrast, .maxIterations = 4});
  run(before);
  FastSearch after(target(5), options, &before), anew(target(5), options);
  const std::size_t measured = run(after), measuredAnew = run(anew);
  EXPECT_LT(static_cast<double>(measured), 0.75 * static_cast<double>(measuredAnew));
  EXPECT_LT(meanMm(after.depths()), 1.01 * meanMm(anew.depths()));
  EXPECT_EQ(after.limitedCount(), 0u);
  const Grid<double> all = luminances(after.depths());
  for (const std::uint32_t i : sky_.carved()) {
    const int row = static_cast<int>(i) / mask_.rows(), column = static_cast<int>(i) % mask_.rows();
    const auto module = static_cast<std::size_t>(row / 5 * symbol_.size + column / 5);
    EXPECT_LE(luminanceOf(all, row, column), 1 - options.contrastOfModule[module]);
  }
}

TEST_F(FastSearchTest, NeedsOnlyTheRequestedLuminancesAndChecksAllAtTheEnd) {
  FastSearch fast(target(5), {.contrast = kContrast});
  Grid<double> luminance = luminances(fast.depths());
  std::size_t measured = 0;
  bool allInTheEnd = false;
  while (!fast.finished()) {
    const bool all = fast.due().empty();
    measured += all ? sky_.carved().size() : fast.due().size();
    allInTheEnd = allInTheEnd || (all && fast.iterations() >= 3);
    const Grid<double> now = luminances(fast.depths());
    for (const std::uint32_t i : all ? std::span<const std::uint32_t>(sky_.carved()) : fast.due()) {
      const int row = static_cast<int>(i) / mask_.rows() + 20, column = static_cast<int>(i) % mask_.rows() + 20;
      luminance.at(row, column) = now.at(row, column);
    }
    fast.update(luminance);
  }
  EXPECT_TRUE(allInTheEnd);
  EXPECT_EQ(tooBright(fast.depths()), 0);
  EXPECT_LT(measured, static_cast<std::size_t>(fast.iterations()) * sky_.carved().size() * 3 / 4);
}

TEST_F(FastSearchTest, LeavesFewSubmodulesDeeperThanNecessary) {
  FastSearch fast(target(5), {.contrast = kContrast, .slackMm = 0.05});
  run(fast);
  int tooDeep = 0;
  for (const std::uint32_t i : sky_.carved()) {
    DepthField less = fast.depths();
    less.depthMm[i] = std::max(0.01, less.depthMm[i] - 0.1);
    tooDeep += tooBright(less) == 0;
  }
  EXPECT_LE(tooDeep, static_cast<int>(sky_.carved().size()) / 100);
}

TEST(DepthBounds, InterpolateTheDepthBetweenTooBrightAndDarkEnough) {
  DepthBounds bounds;
  bounds.measured(0.5, 0.8, 0.7);
  EXPECT_FALSE(bounds.isClosed());
  bounds.measured(0.6, 0.6, 0.7);
  ASSERT_TRUE(bounds.isClosed());
  EXPECT_NEAR(bounds.neededMm(0.7), 0.55, 1e-12);
  EXPECT_NEAR(bounds.nextMm(0.7), 0.55, 1e-12);
  // The edge of a shadow: the line is far off.
  bounds.measured(0.6, 0.1, 0.7);
  EXPECT_NEAR(bounds.neededMm(0.7), 0.5 + 0.1 / 7, 1e-12);
  EXPECT_NEAR(bounds.nextMm(0.7), 0.525, 1e-12);
  bounds.measured(0.58, 0.75, 0.7);
  EXPECT_EQ(bounds.nextMm(0.7), 0.6);
  bounds.measured(0.6, 0.71, 0.7);  // a neighbour became deeper
  EXPECT_FALSE(bounds.isClosed());
}

TEST_F(FastSearchTest, UnderLampsASmallDifferenceInTheLightShiftsNoPocketByAStep) {
  const auto found = [&](double brighter) {
    FastSearch search(target(5), {.contrast = 0.6, .hasLamps = true, .maxIterations = 60});
    while (!search.finished()) {
      Grid<double> all = luminances(search.depths());
      for (const std::uint32_t i : sky_.carved())
        all.at(static_cast<int>(i) / mask_.rows() + kQuietZoneSubmodules,
               static_cast<int>(i) % mask_.rows() + kQuietZoneSubmodules) *= brighter;
      search.update(all);
    }
    EXPECT_EQ(search.limitedCount(), 0u);
    EXPECT_LT(search.iterations(), 40);
    return search.depths();
  };
  const DepthField one = found(1), other = found(1.004);
  int shifted = 0;
  for (const std::uint32_t i : sky_.carved()) shifted += std::abs(one.depthMm[i] / other.depthMm[i] - 1) > 0.05;
  EXPECT_LE(shifted, static_cast<int>(sky_.carved().size()) / 200);
}

TEST_F(FastSearchTest, StopsAtTheLimitsAndCountsSubmodulesThatStayTooBright) {
  FastSearch fast(target(0.123), {.contrast = kContrast});
  run(fast);
  for (const double depth : fast.depths().depthMm) EXPECT_LE(depth, 0.123);
  EXPECT_EQ(fast.limitedCount(), static_cast<std::size_t>(tooBright(fast.depths())));
  EXPECT_GT(fast.limitedCount(), 0u);
}

TEST_F(FastSearchTest, CountsSubmodulesThatTheLastPassLeavesTooBright) {
  FastSearch fast(target(5), {.contrast = kContrast, .maxIterations = 1});
  run(fast);
  EXPECT_EQ(fast.iterations(), 1);
  EXPECT_EQ(fast.limitedCount(), static_cast<std::size_t>(tooBright(fast.depths())));
  EXPECT_EQ(fast.unfinishedCount(), fast.limitedCount());
  EXPECT_GT(fast.unfinishedCount(), 0u);
}

TEST_F(FastSearchTest, CarvesNothingIfTheLimitIsZero) {
  FastSearch fast(target(0), {.contrast = kContrast});
  run(fast);
  EXPECT_EQ(fast.iterations(), 1);
  EXPECT_EQ(meanMm(fast.depths()), 0);
  EXPECT_EQ(fast.limitedCount(), sky_.carved().size());
}

}  // namespace
}  // namespace qrelief
