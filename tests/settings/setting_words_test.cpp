// SPDX-License-Identifier: GPL-3.0-or-later
#include "messages/setting_words.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <set>

#include "messages/sentences.h"
#include "settings/settings.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;

std::set<std::string> keysOf(const Json& object) {
  std::set<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.insert(key);
  return keys;
}

TEST(SettingWords, EverySettingHasLabelHelpAndNamesOfItsChoices) {
  for (const Setting& setting : settings()) {
    ASSERT_TRUE(settingWords().at("settings").contains(setting.key)) << setting.key;
    const Json& words = settingWords().at("settings").at(setting.key);
    EXPECT_NE(words.at("label"), "") << setting.key;
    EXPECT_NE(words.at("help"), "") << setting.key;
    std::set<std::string> choices(setting.choices.begin(), setting.choices.end());
    if (setting.kind == Setting::Kind::ChoiceOrNumber) choices.insert("number");
    if (setting.kind == Setting::Kind::ChoiceOrVector) choices.insert("vector");
    const Json named = words.value("choices", Json::object());
    EXPECT_EQ(keysOf(named), choices) << setting.key;
    std::set<std::string> parts;
    if (setting.kind == Setting::Kind::ChoiceOrNumber) parts.insert("number");
    if (setting.kind == Setting::Kind::Lamps)
      for (const LampPart& part : lampParts()) parts.emplace(part.key);
    const Json labelled = words.value("parts", Json::object());
    EXPECT_EQ(keysOf(labelled), parts) << setting.key;
  }
}

TEST(SettingWords, NothingElseHasWords) {
  for (const std::string& key : keysOf(settingWords().at("settings"))) EXPECT_NE(findSetting(key), nullptr) << key;
}

TEST(SettingWords, EveryGroupHasItsName) {
  std::set<std::string> groups;
  for (const Setting& setting : settings()) groups.insert(setting.group);
  EXPECT_EQ(keysOf(settingWords().at("groups")), groups);
}

TEST(SettingWords, EveryUnitIsWrittenByItsTraits) {
  std::set<std::string> names;
  for (const UnitTraits& unit : units()) {
    EXPECT_EQ(&traitsOf(unit.unit), &unit);
    if (unit.unit == Unit::None) continue;
    const std::string name(unit.name);
    EXPECT_TRUE(names.insert(name).second) << name;
    ASSERT_TRUE(settingWords().at("units").contains(name)) << name;
    EXPECT_EQ(settingWords().at("units").at(name), unit.symbol);
    if (!unit.keySuffix.empty()) {
      EXPECT_EQ(flagOf("aValue" + std::string(unit.keySuffix)), "--a-value");
    }
  }
  EXPECT_EQ(keysOf(settingWords().at("units")), names);
}

}  // namespace
}  // namespace qrelief
