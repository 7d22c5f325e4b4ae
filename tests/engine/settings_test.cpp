// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/settings.h"

#include <gtest/gtest.h>

#include "messages/sentences.h"

namespace qrelief {
namespace {

TEST(Settings, EverySettingArrives) {
  const auto request =
      readSettings(R"({"text": "grüezi", "ecc": "Q", "pattern": "thin-plus", "finderPattern": "diamond",
      "size": 35.5, "maxSizeMm": 80, "quietZone": false, "direction": "mean-normal", "rotateDeg": 30, "contrast": 0.4,
      "minWallMm": 1.2, "nozzleMm": 0.6, "layerMm": 0.2, "maxDepthMm": 0.9, "eyeDistanceMm": 300})");
  ASSERT_TRUE(request.has_value()) << request.error().message;
  EXPECT_EQ(request->text, "grüezi");
  EXPECT_EQ(request->symbol.errorCorrection, ErrorCorrection::Q);
  EXPECT_EQ(request->modulePattern, ModulePattern::ThinPlus);
  EXPECT_EQ(request->finderPattern, FinderPattern::Diamond);
  EXPECT_EQ(request->placement.sizeMode, SizeMode::Fixed);
  EXPECT_EQ(request->placement.sizeMm, 35.5);
  EXPECT_EQ(request->placement.maxSizeMm, 80);
  EXPECT_FALSE(request->placement.quietZone);
  EXPECT_EQ(request->placement.directionMethod, DirectionMethod::MeanNormal);
  EXPECT_EQ(request->placement.rotateDeg, 30);
  EXPECT_EQ(request->contrast, 0.4);
  EXPECT_EQ(request->minWallMm, 1.2);
  EXPECT_EQ(request->nozzleMm, 0.6);
  EXPECT_EQ(request->layerMm, 0.2);
  EXPECT_EQ(request->maxDepthMm, 0.9);
  EXPECT_EQ(request->placement.eyeDistanceMm, 300);
}

TEST(Settings, APresetGivesWhatIsNotSaidItself) {
  const auto robust = readSettings(R"({"text": "x", "preset": "robust"})");
  ASSERT_TRUE(robust.has_value());
  EXPECT_GT(robust->contrastAsked(), EngraveRequest{}.contrastAsked());
  const auto own =
      readSettings(R"({"text": "x", "preset": "robust", "contrast": 0.25, "pattern": "square", "ecc": "M"})");
  ASSERT_TRUE(own.has_value());
  EXPECT_EQ(own->contrast, 0.25);
  EXPECT_EQ(own->modulePattern, ModulePattern::Square);
  EXPECT_FALSE(own->symbol.raiseErrorCorrection);
  const auto unknown = readSettings(R"({"text": "x", "preset": "deep"})");
  ASSERT_FALSE(unknown.has_value());
  EXPECT_EQ(unknown.error().kind, ErrorKind::BadUsage);
}

TEST(Settings, WhatIsMissingOrNullHasItsDefault) {
  const auto request = readSettings(R"({"text": "x", "maxDepthMm": null, "size": "best", "direction": "optimal"})");
  ASSERT_TRUE(request.has_value());
  EXPECT_EQ(request->placement.sizeMode, SizeMode::Best);
  EXPECT_EQ(request->placement.directionMethod, DirectionMethod::Optimal);
  EXPECT_FALSE(request->maxDepthMm.has_value());
  EXPECT_EQ(request->symbol.errorCorrection, ErrorCorrection::M);
  EXPECT_TRUE(request->symbol.raiseErrorCorrection);
  EXPECT_EQ(request->contrast, EngraveRequest{}.contrast);
}

TEST(Settings, ASettingOfTheWrongKindIsNamed) {
  const std::pair<const char*, const char*> cases[] = {{R"({"ecc": "X"})", "ecc"},
                                                       {R"({"pattern": "round"})", "pattern"},
                                                       {R"({"size": "huge"})", "size"},
                                                       {R"({"contrast": "0.3"})", "contrast"},
                                                       {R"({"quietZone": 1})", "quietZone"},
                                                       {R"({"text": 5})", "text"},
                                                       {R"({"direction": "up"})", "direction"}};
  for (const auto& [json, name] : cases) {
    const auto request = readSettings(json);
    ASSERT_FALSE(request.has_value()) << json;
    EXPECT_EQ(request.error().kind, ErrorKind::BadUsage);
    EXPECT_NE(sentence(request.error().message).find(std::string("setting ") + name), std::string::npos)
        << request.error().message;
  }
}

TEST(Settings, WhatIsNoJsonObjectIsRefused) {
  for (const char* json : {"", "[]", "{", "3", "{\"text\": \"\xff\"}"})
    EXPECT_FALSE(readSettings(json).has_value()) << json;
}

}  // namespace
}  // namespace qrelief
