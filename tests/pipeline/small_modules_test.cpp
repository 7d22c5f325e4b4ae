// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/small_modules.h"

#include <gtest/gtest.h>
#include <vector>

#include "settings/settings.h"
#include "verification/printability.h"

namespace qrelief {
namespace {

constexpr double kNozzleMm = 0.4, kSmallMm = 1.0, kLargeMm = 1.05;

class SmallModulesTest : public testing::Test {
 protected:
  SmallModulesTest() {
    request_.text = "https://example.org/p/2026";
    request_.printer.nozzleMm = kNozzleMm;
    request_.symbol.errorCorrection = ErrorCorrection::Q;
    symbol_ = *encodeSymbol(request_.text, request_.symbol);
  }

  SizedCode at(double moduleMm) const { return codeOfSize(request_, symbol_, moduleMm); }

  EngraveRequest request_ = defaultRequest();
  Symbol symbol_;
};

TEST_F(SmallModulesTest, ModulesNarrowerThanTwoPointSixNozzlesAreCarvedWholeAndBrokenUp) {
  const SizedCode small = at(kSmallMm);
  EXPECT_EQ(small.request.modulePattern, ModulePattern::None);
  EXPECT_EQ(small.request.finderPattern, FinderPattern::None);
  EXPECT_NEAR(small.request.contrastAsked(), 0.25, 1e-12);
  EXPECT_EQ(small.request.maxDepthMm, 4 * kSmallMm);
  SymbolOptions brokenUp = request_.symbol;
  brokenUp.breakUpDarkAreas = true;
  EXPECT_EQ(small.symbol.dark, encodeSymbol(request_.text, brokenUp)->dark);
  EXPECT_NE(small.symbol.dark, symbol_.dark);
}

TEST_F(SmallModulesTest, OthersHaveThickPlusAndStayAsTheyAre) {
  const SizedCode large = at(kLargeMm);
  EXPECT_EQ(large.request.modulePattern, ModulePattern::ThickPlus);
  EXPECT_EQ(large.request.finderPattern, FinderPattern::ThickPlusSharp);
  EXPECT_EQ(large.request.contrast, std::nullopt);
  EXPECT_EQ(large.request.maxDepthMm, 1.2 * kLargeMm);
  EXPECT_EQ(large.symbol.dark, symbol_.dark);
}

TEST_F(SmallModulesTest, ItIsTheNozzleThatSaysWhatIsSmall) {
  request_.printer.nozzleMm = 0.25;
  EXPECT_EQ(at(0.64).request.modulePattern, ModulePattern::None);
  EXPECT_EQ(at(0.66).request.modulePattern, ModulePattern::ThickPlus);
}

TEST_F(SmallModulesTest, WhatTheRequestSaysItselfStays) {
  request_.contrast = 0.4;
  request_.maxDepthMm = 0.9;
  request_.finderPattern = FinderPattern::Diamond;
  const SizedCode small = at(kSmallMm);
  EXPECT_EQ(small.request.modulePattern, ModulePattern::None);
  EXPECT_EQ(small.request.finderPattern, FinderPattern::Diamond);
  EXPECT_EQ(small.request.contrast, 0.4);
  EXPECT_EQ(small.request.maxDepthMm, 0.9);
}

TEST_F(SmallModulesTest, ANamedPatternOrAnotherWayOfCarvingChangesNothingElse) {
  std::vector<EngraveRequest> others(6, request_);
  others[0].modulePattern = ModulePattern::None;
  others[1].process.reset();
  others[2].lights = {DirectionalLight{}};
  others[3].floor = FloorShape::Wavy;
  others[4].solver = ContrastSolver::PaperSteps;
  others[5].objective = DepthObjective::Reading;
  for (const EngraveRequest& other : others) {
    const SizedCode code = codeOfSize(other, symbol_, kSmallMm);
    EXPECT_EQ(code.request.modulePattern, other.modulePattern.value_or(ModulePattern::ThickPlus));
    EXPECT_EQ(code.request.finderPattern, FinderPattern::ThickPlusSharp);
    EXPECT_EQ(code.request.contrast, std::nullopt);
    EXPECT_EQ(code.request.maxDepthMm, 1.2 * kSmallMm);
    EXPECT_EQ(code.symbol.dark, symbol_.dark);
  }
}

TEST_F(SmallModulesTest, DecidingTwiceIsDecidingOnce) {
  const SizedCode once = at(kSmallMm), twice = codeOfSize(once.request, once.symbol, kSmallMm);
  EXPECT_EQ(twice.request, once.request);
  EXPECT_EQ(twice.symbol.dark, once.symbol.dark);
}

TEST_F(SmallModulesTest, WhatPrintsAtLeastIsSaidOfThePatternThatIsNamedElseOfThickPlus) {
  const double thickPlus =
      leastPrintableModuleMm(symbol_, ModulePattern::ThickPlus, FinderPattern::ThickPlusSharp, request_.printer);
  EXPECT_EQ(leastPrintableModuleMm(symbol_, request_), thickPlus);
  request_.modulePattern = ModulePattern::Square;
  EXPECT_GT(leastPrintableModuleMm(symbol_, request_), thickPlus);
}

}  // namespace
}  // namespace qrelief
