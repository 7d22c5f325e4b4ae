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

/// Returns the names of texts that lack words in a language.
std::vector<std::string> unsaid(const std::string& what, const Json& words) {
  std::vector<std::string> missing;
  for (const char* language : {"en", "de"})
    if (!words.contains(language) || words.at(language).get<std::string>().empty())
      missing.push_back(what + " in " + language);
  return missing;
}

std::set<std::string> keysOf(const Json& object) {
  std::set<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.insert(key);
  return keys;
}

TEST(SettingWords, EverySettingHasLabelHelpAndNamesOfItsChoicesInBothLanguages) {
  for (const Setting& setting : settings()) {
    ASSERT_TRUE(settingWords().at("settings").contains(setting.key)) << setting.key;
    const Json& words = settingWords().at("settings").at(setting.key);
    EXPECT_THAT(unsaid("label", words.at("label")), testing::IsEmpty()) << setting.key;
    EXPECT_THAT(unsaid("help", words.at("help")), testing::IsEmpty()) << setting.key;
    for (const char* other : {"hint", "empty", "without"})
      EXPECT_THAT(unsaid(other, words.value(other, words.at("help"))), testing::IsEmpty()) << setting.key;
    std::set<std::string> choices(setting.choices.begin(), setting.choices.end());
    if (setting.kind == Setting::Kind::ChoiceOrNumber) choices.insert("number");
    if (setting.kind == Setting::Kind::ChoiceOrVector) choices.insert("vector");
    const Json named = words.value("choices", Json::object());
    EXPECT_EQ(keysOf(named), choices) << setting.key;
    for (const auto& [choice, name] : named.items())
      EXPECT_THAT(unsaid(choice, name), testing::IsEmpty()) << setting.key;
    std::set<std::string> parts;
    if (setting.kind == Setting::Kind::ChoiceOrNumber) parts.insert("number");
    if (setting.kind == Setting::Kind::Lamps)
      for (const LampPart& part : lampParts()) parts.emplace(part.key);
    const Json labelled = words.value("parts", Json::object());
    EXPECT_EQ(keysOf(labelled), parts) << setting.key;
    for (const auto& [part, label] : labelled.items())
      EXPECT_THAT(unsaid(part, label), testing::IsEmpty()) << setting.key;
  }
}

TEST(SettingWords, NothingElseHasWords) {
  for (const std::string& key : keysOf(settingWords().at("settings"))) EXPECT_NE(findSetting(key), nullptr) << key;
}

TEST(SettingWords, EveryGroupAndUnitHasItsNameInBothLanguages) {
  std::set<std::string> groups;
  for (const Setting& setting : settings()) groups.insert(setting.group);
  EXPECT_EQ(keysOf(settingWords().at("groups")), groups);
  for (const char* part : {"groups", "units"})
    for (const auto& [key, words] : settingWords().at(part).items())
      EXPECT_THAT(unsaid(key, words), testing::IsEmpty());
}

TEST(SettingWords, EveryUnitIsWrittenByItsTraits) {
  std::set<std::string> names;
  for (const UnitTraits& unit : units()) {
    EXPECT_EQ(&traitsOf(unit.unit), &unit);
    if (unit.unit == Unit::None) continue;
    const std::string name(unit.name);
    EXPECT_TRUE(names.insert(name).second) << name;
    ASSERT_TRUE(settingWords().at("units").contains(name)) << name;
    EXPECT_EQ(settingWords().at("units").at(name).at("en"), unit.symbol);
    if (!unit.keySuffix.empty()) {
      EXPECT_EQ(flagOf("aValue" + std::string(unit.keySuffix)), "--a-value");
    }
  }
  EXPECT_EQ(keysOf(settingWords().at("units")), names);
}

}  // namespace
}  // namespace qrelief
