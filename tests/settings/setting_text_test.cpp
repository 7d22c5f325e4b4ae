// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/setting_text.h"

#include <gtest/gtest.h>

#include "settings/engrave_request.h"

namespace qrelief {
namespace {

Result<SettingValue> valueOf(const char* key, const std::vector<std::string>& texts) {
  return valueFromText(*findSetting(key), texts);
}

TEST(SettingText, ReadsEveryKindFromTypedText) {
  EXPECT_EQ(valueOf("text", {"a, b"}).value(), SettingValue("a, b"));
  EXPECT_EQ(valueOf("quietZone", {"off"}).value(), SettingValue(false));
  for (const char* on : {"on", "true", "TRUE", "Yes"})
    EXPECT_EQ(valueOf("quietZone", {on}).value(), SettingValue(true)) << on;
  for (const char* off : {"OFF", "false", "FALSE", "no"})
    EXPECT_EQ(valueOf("quietZone", {off}).value(), SettingValue(false)) << off;
  EXPECT_EQ(valueOf("minWallMm", {"1.5"}).value(), SettingValue(1.5));
  EXPECT_EQ(valueOf("minWallMm", {"-3"}).value(), SettingValue(-3.0)) << "ranges are checked elsewhere";
  EXPECT_EQ(valueOf("pattern", {"thin-plus"}).value(), SettingValue("thin-plus"));
  EXPECT_EQ(valueOf("patternMask", {"11111/10001/10001/10001/11111"}).value(),
            SettingValue("11111/10001/10001/10001/11111"));
  EXPECT_EQ(valueOf("size", {"35"}).value(), SettingValue(35.0));
  EXPECT_EQ(valueOf("size", {"best"}).value(), SettingValue("best"));
  EXPECT_EQ(valueOf("direction", {"pca"}).value(), SettingValue("pca"));
  EXPECT_EQ(valueOf("direction", {"0.1,0,-1"}).value(), SettingValue(Vec3(0.1, 0, -1)));
  EXPECT_EQ(valueOf("light", {"90,60", "0,75,0.5"}).value(),
            SettingValue(std::vector<DirectionalLight>{{90, 60, 1}, {0, 75, 0.5}}));
}

TEST(SettingText, RefusesAnythingElseAndQuotesIt) {
  const std::tuple<const char*, std::vector<std::string>, const char*> cases[] = {
      {"minWallMm", {"thin"}, "setting-no-number"},
      {"minWallMm", {"1 mm"}, "setting-no-number"},
      {"minWallMm", {""}, "setting-no-number"},
      {"minWallMm", {"nan"}, "setting-no-number"},
      {"minWallMm", {"inf"}, "setting-no-number"},
      {"pattern", {"dots"}, "setting-no-choice"},
      {"patternMask", {"00100/01110/00100"}, "setting-no-mask"},
      {"size", {"large"}, "setting-no-choice-or-number"},
      {"direction", {"1,2"}, "setting-no-choice-or-vector"},
      {"direction", {"1,2,3,4"}, "setting-no-choice-or-vector"},
      {"direction", {"1,2,x"}, "setting-no-choice-or-vector"},
      {"up", {"z"}, "setting-no-vector"},
      {"quietZone", {"1"}, "setting-no-switch"},
      {"light", {"90"}, "setting-no-lamps"},
      {"light", {"90,45", "1,2,3,4"}, "setting-no-lamps"},
      {"light", {"90,high"}, "setting-no-lamps"}};
  for (const auto& [key, texts, code] : cases) {
    const auto value = valueOf(key, texts);
    ASSERT_FALSE(value.has_value()) << key;
    EXPECT_EQ(value.error().kind, ErrorKind::BadUsage);
    EXPECT_EQ(value.error().message.code, code) << key << ' ' << texts.back();
    EXPECT_NE(value.error().message.values[1].text.find('"' + texts.front() + '"'), std::string::npos);
  }
}

TEST(SettingText, ReadsBackWhatItWrote) {
  for (const Setting& setting : settings()) {
    const SettingValue value = setting.read(defaultRequest());
    const std::string text = valueText(value);
    if (text.empty()) continue;
    const std::vector<std::string> texts = {text};
    EXPECT_EQ(valueFromText(setting, texts).value(), value) << setting.key << ' ' << text;
  }
  EXPECT_EQ(valueText(0.8), "0.8");
  EXPECT_EQ(valueText(Vec3(0, -1.5, 1)), "0,-1.5,1");
}

}  // namespace
}  // namespace qrelief
