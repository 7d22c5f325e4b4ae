// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/setting_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "message_codes/settings_errors.h"
#include "messages/sentences.h"
#include "settings/engrave_request.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;

TEST(SettingJson, EverySettingOfThePageArrives) {
  const auto request =
      requestFromJson(R"({"text": "grüezi", "ecc": "Q", "pattern": "thin-plus", "finderPattern": "diamond",
      "size": 35.5, "maxSizeMm": 80, "quietZone": false, "direction": "mean-normal", "rotateDeg": 30, "contrast": 0.4,
      "minWallMm": 1.2, "nozzleMm": 0.6, "layerMm": 0.2, "maxDepthMm": 0.9, "eyeDistanceMm": 300})");
  ASSERT_TRUE(request.has_value()) << request.error().message;
  EXPECT_EQ(request->code.text, "grüezi");
  EXPECT_EQ(request->code.symbol.errorCorrection, ErrorCorrection::Q);
  EXPECT_EQ(request->code.modulePattern, ModulePattern::ThinPlus);
  EXPECT_EQ(request->code.finderPattern, FinderPattern::Diamond);
  EXPECT_EQ(request->placement.sizeMode, SizeMode::Fixed);
  EXPECT_EQ(request->placement.sizeMm, 35.5);
  EXPECT_EQ(request->placement.maxSizeMm, 80);
  EXPECT_FALSE(request->placement.quietZone);
  EXPECT_EQ(request->placement.directionMethod, DirectionMethod::MeanNormal);
  EXPECT_EQ(request->placement.rotateDeg, 30);
  EXPECT_EQ(request->depth.contrast, 0.4);
  EXPECT_EQ(request->depth.minWallMm, 1.2);
  EXPECT_EQ(request->print.printer.nozzleMm, 0.6);
  EXPECT_EQ(request->print.printer.layerMm, 0.2);
  EXPECT_EQ(request->depth.maxDepthMm, 0.9);
  EXPECT_EQ(request->placement.eyeDistanceMm, 300);
}

TEST(SettingJson, RefusesDeepNestingAndDuplicateKeys) {
  const auto codeOf = [](const std::string& json) { return requestFromJson(json).error().message.code; };
  EXPECT_EQ(codeOf("{\"text\": " + std::string(100'000, '[') + std::string(100'000, ']') + "}"), "json-too-deep");
  EXPECT_EQ(codeOf(R"({"text": "a", "text": "b"})"), "json-key-twice");
  EXPECT_EQ(codeOf("no JSON"), "settings-no-object");
}

TEST(SettingJson, APresetGivesTheSettingsThatAreMissing) {
  const auto robust = requestFromJson(R"({"text": "x", "preset": "robust"})");
  ASSERT_TRUE(robust.has_value());
  EXPECT_GT(robust->depth.contrastAsked(), EngraveRequest{}.depth.contrastAsked());
  const auto own =
      requestFromJson(R"({"text": "x", "contrast": 0.25, "pattern": "square", "ecc": "M", "preset": "robust"})");
  ASSERT_TRUE(own.has_value());
  EXPECT_EQ(own->depth.contrast, 0.25);
  EXPECT_EQ(own->code.modulePattern, ModulePattern::Square);
  EXPECT_FALSE(own->code.symbol.raiseErrorCorrection);
}

TEST(SettingJson, MissingOrNullSettingsHaveTheirDefaults) {
  const auto request = requestFromJson(
      R"({"text": "x", "maxDepthMm": null, "minWallMm": null, "size": "best", "direction": "optimal"})");
  ASSERT_TRUE(request.has_value());
  EXPECT_EQ(request->placement.sizeMode, SizeMode::Best);
  EXPECT_EQ(request->placement.directionMethod, DirectionMethod::Optimal);
  EXPECT_FALSE(request->depth.maxDepthMm.has_value());
  EXPECT_EQ(request->depth.minWallMm, 0.8);
  EXPECT_EQ(request->code.symbol, defaultRequest().code.symbol);
  EXPECT_EQ(request->depth.contrast, std::nullopt);
}

/// Returns requests in which every setting differs from its default, covering each kind of value that it takes.
std::vector<EngraveRequest> unusualRequests() {
  std::vector<EngraveRequest> all(3, defaultRequest());
  for (const Setting& setting : settings()) {
    if (setting.kind == Setting::Kind::Text) setting.write(all[0], "grüezi \"☕\"\n");
    if (setting.kind == Setting::Kind::Mask) setting.write(all[0], "11111/10001/10001/10001/11111");
    if (setting.kind == Setting::Kind::Switch) setting.write(all[0], !std::get<bool>(setting.read(defaultRequest())));
    if (setting.takesChoice()) setting.write(all[0], setting.choices.back());
    if (setting.takesNumber()) {
      setting.write(all[1], setting.min);
      setting.write(all[2], setting.max);
    }
    if (setting.takesVector()) setting.write(all[1], Vec3(0.25, -1, 3));
    if (setting.kind == Setting::Kind::Lamps)
      setting.write(all[1], std::vector<DirectionalLight>{{30, 60, 2}, {.azimuthDeg = -90}});
  }
  return all;
}

TEST(SettingJson, EveryKeyIsWrittenAndReadBack) {
  for (const EngraveRequest& request : unusualRequests()) {
    const std::string json = settingsJson(request);
    const auto back = requestFromJson(json);
    ASSERT_TRUE(back.has_value()) << json << sentence(back.error().message);
    for (const Setting& setting : settings()) EXPECT_EQ(setting.read(*back), setting.read(request)) << setting.key;
    EXPECT_EQ(*back, request) << json;
    const Json object = Json::parse(json);
    for (const Setting& setting : settings()) EXPECT_TRUE(object.contains(setting.key)) << setting.key;
  }
}

TEST(SettingJson, RefusesASettingOfTheWrongKindByNameAndValue) {
  const std::tuple<const char*, const char*, const char*> cases[] = {
      {R"({"ecc": "X"})", "setting-no-choice", R"(--ecc is "X")"},
      {R"({"preset": "deep"})", "setting-no-choice", R"(--preset is "deep")"},
      {R"({"patternMask": "11111"})", "setting-no-mask", R"(--pattern-mask is "11111")"},
      {R"({"patternMask": 11111})", "setting-no-mask", "--pattern-mask is 11111"},
      {R"({"size": "huge"})", "setting-no-choice-or-number", R"(--size is "huge")"},
      {R"({"size": true})", "setting-no-choice-or-number", "--size is true"},
      {R"({"mask": "first"})", "setting-no-choice-or-number", R"(--mask is "first")"},
      {R"({"contrast": "0.3"})", "setting-no-number", R"(--contrast is "0.3")"},
      {R"({"contrast": [0.3]})", "setting-no-number", "--contrast is [0.3]"},
      {R"({"quietZone": 1})", "setting-no-switch", "--quiet-zone is 1"},
      {R"({"text": 5})", "setting-no-text", "--text is 5"},
      {R"({"direction": "up"})", "setting-no-choice-or-vector", R"(--direction is "up")"},
      {R"({"direction": [0, 1]})", "setting-no-choice-or-vector", "--direction is [0,1]"},
      {R"({"up": "z"})", "setting-no-vector", R"(--up is "z")"},
      {R"({"light": [{"azimuth": 3}]})", "setting-no-lamps", R"(--light is [{"azimuth":3}])"},
      {R"({"light": {}})", "setting-no-lamps", "--light is {}"}};
  for (const auto& [json, code, said] : cases) {
    const auto request = requestFromJson(json);
    ASSERT_FALSE(request.has_value()) << json;
    EXPECT_EQ(request.error().kind, ErrorKind::BadUsage);
    EXPECT_EQ(request.error().message.code, code) << json;
    EXPECT_EQ(sentence(request.error().message).substr(0, std::string_view(said).size()), said);
  }
}

TEST(SettingJson, RefusesAnUnknownKeyByName) {
  const auto request = requestFromJson(R"({"text": "x", "minWall": 3})");
  ASSERT_FALSE(request.has_value());
  EXPECT_EQ(request.error().message, message<"setting-unknown">(with::quoted<"key">("minWall")));
}

TEST(SettingJson, RefusesTextThatIsNotAJsonObject) {
  for (const char* json : {"", "[]", "{", "3", "{\"text\": \"\xff\"}"})
    EXPECT_FALSE(requestFromJson(json).has_value()) << json;
}

}  // namespace
}  // namespace qrelief
