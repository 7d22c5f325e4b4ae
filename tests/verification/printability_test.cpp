// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/printability.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages/sentences.h"

namespace qrelief {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

CarvedFeatures carvedWith(ModulePattern modules, FinderPattern finders, double moduleMm, double depthMm) {
  const Symbol symbol = *encodeSymbol("QRELIEF", {.version = 1});
  const SubmoduleMask mask = submodulesToCarve(symbol, modules, finders);
  return measureFeatures(symbol, mask, std::vector<double>(mask.size(), depthMm), moduleMm);
}

std::vector<Message> adviceFor(ModulePattern modules, double moduleMm, const Printer& printer = {}) {
  return advisePrinting(carvedWith(modules, FinderPattern::ThickPlus, moduleMm, 0.5), printer);
}

TEST(MeasureFeatures, RecognisesThePatternsAndTheirNarrowestParts) {
  const auto pocketOf = [](ModulePattern pattern) {
    const CarvedFeatures features = carvedWith(pattern, FinderPattern::AsModules, 1, 0.5);
    EXPECT_EQ(features.pattern, pattern);
    return features.pocketMm;
  };
  EXPECT_DOUBLE_EQ(pocketOf(ModulePattern::None), 1);
  EXPECT_DOUBLE_EQ(pocketOf(ModulePattern::Square), 0.6);
  EXPECT_DOUBLE_EQ(pocketOf(ModulePattern::Diamond), 0.6);
  EXPECT_DOUBLE_EQ(pocketOf(ModulePattern::ThickPlus), 0.6);
  EXPECT_DOUBLE_EQ(pocketOf(ModulePattern::ThinPlus), 0.2);
}

TEST(MeasureFeatures, GapsAreTheWallsBetweenPockets) {
  EXPECT_DOUBLE_EQ(carvedWith(ModulePattern::Square, FinderPattern::AsModules, 1, 0.5).gapMm, 0.4);
  // With whole modules carved, only light modules separate them.
  EXPECT_DOUBLE_EQ(carvedWith(ModulePattern::None, FinderPattern::None, 1, 0.5).gapMm, 1);
}

TEST(MeasureFeatures, DepthsAreMeansOverCarvedSubmodulesAndTheShallowModules) {
  const Symbol symbol = *encodeSymbol("QRELIEF", {.version = 1});
  const SubmoduleMask mask = submodulesToCarve(symbol, ModulePattern::None, FinderPattern::None);
  std::vector<double> depths;
  for (int i = 0; i < mask.rows() * mask.rows(); ++i) depths.push_back(i / mask.rows() < mask.rows() / 2 ? 0.2 : 0.6);
  const CarvedFeatures features = measureFeatures(symbol, mask, depths, 1);
  EXPECT_DOUBLE_EQ(features.leastDepthMm, 0.2);
  EXPECT_GT(features.meanDepthMm, 0.3);
  EXPECT_LT(features.meanDepthMm, 0.5);
}

TEST(MeasureFeatures, NothingCarvedHasNoFeatures) {
  const Symbol symbol = *encodeSymbol("QRELIEF", {.version = 1});
  const SubmoduleMask none(5 * symbol.size, 5 * symbol.size);
  const CarvedFeatures features = measureFeatures(symbol, none, std::vector<double>(none.size(), 0), 1);
  EXPECT_EQ(features.pattern, std::nullopt);
  EXPECT_EQ(features.pocketMm, 0);
}

TEST(AdvisePrinting, AgreesWithThePublishedPrints) {
  EXPECT_THAT(adviceFor(ModulePattern::None, 1.2), IsEmpty());
  EXPECT_THAT(adviceFor(ModulePattern::Square, 0.9), IsEmpty());
  EXPECT_THAT(adviceFor(ModulePattern::Diamond, 0.9), IsEmpty());
  EXPECT_THAT(adviceFor(ModulePattern::ThickPlus, 0.6), IsEmpty());
  EXPECT_THAT(adviceFor(ModulePattern::Square, 0.85), SizeIs(1));
  EXPECT_THAT(adviceFor(ModulePattern::Diamond, 0.85), SizeIs(1));
  EXPECT_FALSE(adviceFor(ModulePattern::ThickPlus, 0.55).empty());
}

TEST(AdvisePrinting, ThinPlusIsTooNarrowAndSquareIsSuggested) {
  const auto advice = adviceFor(ModulePattern::ThinPlus, 1.2);
  ASSERT_FALSE(advice.empty());
  EXPECT_THAT(sentence(advice.front()), HasSubstr("0.24 mm wide"));
  EXPECT_EQ(hint(advice.front()), "With a 0.4 mm nozzle, choose `square` or modules of 1.8 mm or more");
}

TEST(AdvisePrinting, AFinerNozzleAllowsSmallerModules) {
  EXPECT_THAT(adviceFor(ModulePattern::Square, 0.5, {.nozzleMm = 0.2}), IsEmpty());
  EXPECT_FALSE(adviceFor(ModulePattern::Square, 1.2, {.nozzleMm = 0.8}).empty());
}

TEST(AdvisePrinting, CountsShallowModulesInLayers) {
  const CarvedFeatures shallow = carvedWith(ModulePattern::Square, FinderPattern::ThickPlus, 1.2, 0.3);
  EXPECT_THAT(advisePrinting(shallow, {.layerMm = 0.15}), IsEmpty());
  const auto advice = advisePrinting(shallow, {.layerMm = 0.2});
  ASSERT_THAT(advice, SizeIs(1));
  EXPECT_THAT(sentence(advice.front()), HasSubstr("1.5 layers of 0.2 mm"));
}

TEST(AdvisePrinting, ReportsAThinWall) {
  CarvedFeatures features = carvedWith(ModulePattern::Square, FinderPattern::ThickPlus, 1.2, 0.5);
  features.wallMm = 0.8;
  EXPECT_THAT(advisePrinting(features, {}), IsEmpty());
  features.wallMm = 0.5;
  const auto advice = advisePrinting(features, {});
  ASSERT_THAT(advice, SizeIs(1));
  EXPECT_THAT(sentence(advice.front()), HasSubstr("0.5 mm of material"));
}

}  // namespace
}  // namespace qrelief
