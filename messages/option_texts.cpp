// SPDX-License-Identifier: GPL-3.0-or-later
#include "messages/option_texts.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "messages/sentences.h"
#include "messages/setting_words.h"
#include "settings/engrave_request.h"
#include "settings/preset.h"
#include "settings/setting_text.h"

namespace qrelief {
namespace {

using Kind = Setting::Kind;

/// Replaces the name of a preset by its contrast, and `@key` by a flag.
std::string valueOf(const std::string& name) {
  if (name.starts_with('@')) return flagOf(std::string_view(name).substr(1));
  for (const Preset preset : {Preset::Shallow, Preset::Balanced, Preset::Robust})
    if (name == presetName(preset)) return fmt::format("{:g}", presetContrast(preset));
  return "{" + name + "}";
}

std::string filled(const std::string& words) {
  std::string text;
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t open = std::min(words.find('{', begin), words.size());
    text.append(words, begin, open - begin);
    if (open == words.size()) break;
    const std::size_t close = std::min(words.find('}', open), words.size() - 1);
    text += valueOf(words.substr(open + 1, close - open - 1));
    begin = close + 1;
  }
  return text;
}

std::string numberName(const Setting& setting) {
  const std::string_view name = traitsOf(setting.unit).valueName;
  if (!name.empty()) return std::string(name);
  return setting.isWhole ? "N" : "NUMBER";
}

std::string valuesOf(const Setting& setting) {
  if (setting.kind == Kind::Text) return "TEXT";
  if (setting.kind == Kind::Mask) return "ROWS";
  if (setting.kind == Kind::Lamps) return "AZIMUTH,ELEVATION[,STRENGTH]";
  std::string values = setting.takesNumber() ? numberName(setting) : "";
  for (const std::string& choice : setting.choices) values += (values.empty() ? "" : "|") + choice;
  if (setting.takesVector()) values += values.empty() ? "X,Y,Z" : "|X,Y,Z";
  return values;
}

}  // namespace

OptionTexts optionTexts(const Setting& setting) {
  const nlohmann::json& words = settingWords().at("settings").at(setting.key);
  const SettingValue initial = setting.read(defaultRequest());
  const bool isOnAlready = initial == SettingValue(true) && !words.contains("empty");
  OptionTexts texts;
  texts.flag = flagOf(setting.key);
  if (isOnAlready) texts.flag.insert(2, "no-");
  texts.values = valuesOf(setting);
  texts.help = filled(words.at(isOnAlready ? "without" : "help"));
  if (setting.takesNumber()) texts.range = fmt::format("{} to {}", setting.min, setting.max);
  if (setting.kind == Kind::Switch) texts.initial = "off";
  if (words.contains("empty"))
    texts.initial = filled(words.at("empty"));
  else if (setting.kind != Kind::Switch)
    texts.initial = valueText(initial);
  return texts;
}

}  // namespace qrelief
