// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/default_patterns.h"

#include <gtest/gtest.h>
#include <vector>

#include "settings/engrave_request.h"
#include "settings/settings.h"
#include "verification/printability.h"

namespace qrelief {
namespace {

constexpr double kModuleMm = 1.1, kSmallModuleMm = 1.0;

class DefaultPatternsTest : public testing::Test {
 protected:
  DefaultPatternsTest() {
    request_.code.text = "https://example.org/p/2026";
    request_.print.printer.nozzleMm = 0.4;
    symbol_ = *encodeSymbol(request_.code.text, request_.code.symbol);
  }

  EngraveRequest request_ = defaultRequest();
  Symbol symbol_;
};

TEST_F(DefaultPatternsTest, FinderPatternsAreWholeWithFiveSixthsOfTheContrast) {
  const EngraveRequest carved = withDefaultPatterns(request_, kModuleMm);
  EXPECT_EQ(carved.code.modulePattern, ModulePattern::ThickPlus);
  EXPECT_EQ(carved.code.finderPattern, FinderPattern::None);
  EXPECT_NEAR(carved.depth.contrastAsked(), 0.25, 1e-12);
  EXPECT_EQ(carved.depth.maxDepthMm, kMaxDepthModules * kModuleMm);
}

TEST_F(DefaultPatternsTest, ModulesNarrowerThanTwoPointSixNozzlesUseNineTenths) {
  EXPECT_NEAR(withDefaultPatterns(request_, kSmallModuleMm).depth.contrastAsked(), 0.27, 1e-12);
  request_.print.printer.nozzleMm = 0.25;
  EXPECT_NEAR(withDefaultPatterns(request_, kSmallModuleMm).depth.contrastAsked(), 0.25, 1e-12);
}

TEST_F(DefaultPatternsTest, ThinWallsUsePatternedFindersAndThePresetsContrast) {
  const EngraveRequest carved = withDefaultPatterns(request_, kModuleMm, true);
  EXPECT_EQ(carved.code.modulePattern, ModulePattern::ThickPlus);
  EXPECT_EQ(carved.code.finderPattern, FinderPattern::ThickPlusSharp);
  EXPECT_EQ(carved.depth.contrast, std::nullopt);
}

TEST_F(DefaultPatternsTest, WallsAreThinIfATenthOfTheFindersIsLimitedBelowOneAndAHalfModules) {
  const auto edge = static_cast<std::size_t>(kSubmodulesPerModule * symbol_.size);
  std::vector<double> limits(edge * edge, 1.5 * kModuleMm);
  EXPECT_FALSE(wallsAreThinForWholeFinders(symbol_, limits, kModuleMm));
  for (std::size_t i = edge * 8 * kSubmodulesPerModule; i < limits.size() - edge * 8 * kSubmodulesPerModule; ++i)
    limits[i] = 0;  // below the upper finder patterns and above the lower one
  EXPECT_FALSE(wallsAreThinForWholeFinders(symbol_, limits, kModuleMm));
  for (std::size_t i = 0; i < edge * kSubmodulesPerModule; ++i) limits[i] = 1.4 * kModuleMm;  // 14 of 99 modules
  EXPECT_TRUE(wallsAreThinForWholeFinders(symbol_, limits, kModuleMm));
}

TEST_F(DefaultPatternsTest, KeepsExplicitSettings) {
  request_.depth.contrast = 0.4;
  request_.depth.maxDepthMm = 0.9;
  const EngraveRequest carved = withDefaultPatterns(request_, kModuleMm);
  EXPECT_EQ(carved.code.finderPattern, FinderPattern::None);
  EXPECT_EQ(carved.depth.contrast, 0.4);
  EXPECT_EQ(carved.depth.maxDepthMm, 0.9);
}

TEST_F(DefaultPatternsTest, AnExplicitPatternOrAnotherSolverHasPatternedFinders) {
  std::vector<EngraveRequest> others(6, request_);
  others[0].code.modulePattern = ModulePattern::Diamond;
  others[1].code.finderPattern = FinderPattern::Diamond;
  others[2].depth.lights = {DirectionalLight{}};
  others[3].depth.solver = ContrastSolver::PaperSteps;
  others[4].depth.objective = DepthObjective::OneLight;
  others[5].code.ownPattern = ModulePattern::Square;
  for (const EngraveRequest& other : others) {
    const EngraveRequest carved = withDefaultPatterns(other, kModuleMm);
    EXPECT_EQ(carved.code.modulePattern, other.code.modulePattern.value_or(ModulePattern::ThickPlus));
    EXPECT_EQ(carved.code.finderPattern, other.code.finderPattern.value_or(FinderPattern::ThickPlusSharp));
    EXPECT_EQ(carved.depth.contrast, std::nullopt);
  }
}

TEST_F(DefaultPatternsTest, IsIdempotent) {
  const EngraveRequest once = withDefaultPatterns(request_, kModuleMm);
  EXPECT_EQ(withDefaultPatterns(once, kModuleMm), once);
}

TEST_F(DefaultPatternsTest, TheSmallestPrintableModuleFollowsThePatternElseThickPlus) {
  const double thickPlus =
      leastPrintableModuleMm(symbol_, ModulePattern::ThickPlus, FinderPattern::ThickPlusSharp, request_.print.printer);
  EXPECT_EQ(leastPrintableModuleMm(symbol_, request_), thickPlus);
  request_.code.modulePattern = ModulePattern::Square;
  EXPECT_GT(leastPrintableModuleMm(symbol_, request_), thickPlus);
  request_.code.ownPattern = ModulePattern::ThickPlus;
  EXPECT_EQ(leastPrintableModuleMm(symbol_, request_), thickPlus);
}

}  // namespace
}  // namespace qrelief
