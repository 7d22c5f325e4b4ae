// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/setting_flags.h"

#include <cassert>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "messages/option_texts.h"
#include "messages/sentences.h"
#include "messages/setting_words.h"
#include "settings/engrave_request.h"
#include "settings/setting_text.h"

namespace qrelief {
namespace {

using Kind = Setting::Kind;

std::string helpOf(const OptionTexts& texts, std::string_view before) {
  const std::string initial = texts.initial.empty() ? "" : fmt::format(" [{}]", texts.initial);
  return fmt::format("{}{}{}", before, texts.help, initial);
}

/// Heading in `--help`. A command's own options, such as the text, stay under its first heading.
std::string headingOf(const Setting& setting) {
  if (setting.key == "text") return "Options";
  return settingWords().at("groups").at(setting.group);
}

}  // namespace

CLI::Option& SettingFlags::add(CLI::App& command, std::string_view key, std::string_view before) {
  const Setting* setting = findSetting(key);
  assert(setting);
  const OptionTexts texts = optionTexts(*setting);
  Flag& flag = flags_.emplace_back();
  flag.setting = setting;
  if (setting->kind == Kind::Switch) {
    const std::string help = helpOf(texts, before);
    CLI::Option* option = command.add_flag(texts.flag, help)->group(headingOf(*setting));
    flag.option = option;
    return *option;
  }
  CLI::Option* option = command.add_option(texts.flag, flag.texts, helpOf(texts, before));
  if (setting->kind == Kind::Vector)
    option->delimiter(',')->expected(3);
  else if (setting->kind == Kind::Lamps)
    option->allow_extra_args(false);
  else
    option->expected(1);
  option->type_name(texts.values)->group(headingOf(*setting));
  flag.option = option;
  return *option;
}

void SettingFlags::addGroup(CLI::App& command, std::string_view group) {
  for (const Setting& setting : settings())
    if (setting.group == group && setting.key != "text") add(command, setting.key);
}

void SettingFlags::addAll(CLI::App& command) {
  for (const Setting& setting : settings())
    if (setting.key != "text") add(command, setting.key);
}

const SettingFlags::Flag* SettingFlags::find(std::string_view key) const {
  for (const Flag& flag : flags_)
    if (flag.setting->key == key) return &flag;
  return nullptr;
}

bool SettingFlags::isGiven(std::string_view key) const {
  const Flag* flag = find(key);
  return flag && flag->option->count() > 0;
}

std::vector<std::string> SettingFlags::given() const {
  std::vector<std::string> keys;
  for (const Flag& flag : flags_)
    if (flag.option->count() > 0) keys.push_back(flag.setting->key);
  return keys;
}

Result<SettingValue> SettingFlags::value(std::string_view key) const {
  const Setting& setting = *findSetting(key);
  if (!isGiven(key)) return setting.read(defaultRequest());
  std::vector<std::string> texts = find(key)->texts;
  if (setting.kind == Kind::Switch) texts = {optionTexts(setting).flag.starts_with("--no-") ? "off" : "on"};
  if (setting.kind == Kind::Vector) texts = {fmt::format("{}", fmt::join(texts, ","))};
  auto value = valueFromText(setting, texts);
  if (!value) return value;
  QRELIEF_TRY(checkValue(setting, *value));
  return value;
}

Result<EngraveRequest> SettingFlags::request() const {
  EngraveRequest request = defaultRequest();
  for (const Setting& setting : settings()) {
    if (!isGiven(setting.key)) continue;
    const auto parsed = value(setting.key);
    QRELIEF_TRY(parsed);
    setting.write(request, *parsed);
  }
  return request;
}

}  // namespace qrelief
