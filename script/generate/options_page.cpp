// SPDX-License-Identifier: GPL-3.0-or-later
#include "generate/options_page.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <span>

#include "cli/command_settings.h"
#include "messages/option_texts.h"
#include "messages/setting_words.h"

namespace qrelief {
namespace {

constexpr const char* kPageHead = R"(# Options

<!-- Written by build/release/bin/qrelief_generate from core/settings and locales/en.json: do not edit. -->

Every setting of an engraving, with its flag for `qrelief engrave` and its key in reports, settings files and the page.
The [command line](command-line.md) has the options for files, repairs and batches.

)";

/// Escapes bars, which would end a table cell.
std::string inCell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, 1, '\\');
  return text;
}

std::string nameOfGroup(std::string_view group) {
  return settingWords().at("groups").at(std::string(group)).get<std::string>();
}

/// Says which flags a command accepts.
/// @param listsOfKeys  in addition to the groups
std::string acceptedBy(const char* command, std::span<const char* const> groups,
                       std::initializer_list<std::span<const char* const>> listsOfKeys) {
  std::string names, flags;
  for (const char* group : groups) names += (names.empty() ? "" : " and ") + nameOfGroup(group);
  for (const auto& keys : listsOfKeys)
    for (const char* key : keys) flags += fmt::format(", `{}`", optionTexts(*findSetting(key)).flag);
  return fmt::format("- `{}` accepts `--text`, the flags of {}{}.\n", command, names, flags);
}

std::string rowOf(const Setting& setting) {
  const OptionTexts texts = optionTexts(setting);
  const std::string flag = texts.values.empty() ? texts.flag : texts.flag + " " + texts.values;
  const std::string range = texts.range.empty() ? "" : fmt::format("; {}", texts.range);
  return fmt::format("| `{}` | `{}` | {}{} | {} |\n", inCell(flag), setting.key, inCell(texts.help), range,
                     setting.key == "text" ? "required" : texts.initial);
}

}  // namespace

std::string optionsPage() {
  std::string page = kPageHead, group;
  page += acceptedBy("place", kPlaceGroups, {kPlaceKeys});
  page += acceptedBy("verify", kVerifyGroups, {kVerifyPlaceKeys, kVerifyMarkKeys, kVerifyKeys});
  for (const Setting& setting : settings()) {
    if (setting.group != group) {
      group = setting.group;
      page += fmt::format("\n## {}\n\n| flag | key | meaning | default |\n|---|---|---|---|\n", nameOfGroup(group));
    }
    page += rowOf(setting);
  }
  return page;
}

}  // namespace qrelief
