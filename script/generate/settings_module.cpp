// SPDX-License-Identifier: GPL-3.0-or-later
#include "generate/settings_module.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "settings/engrave_request.h"
#include "settings/setting_json.h"
#include "settings/settings.h"

namespace qrelief {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kModuleHead = R"(// SPDX-License-Identifier: GPL-3.0-or-later
// Written by build/release/bin/qrelief_generate from core/settings: do not edit.

/**
 * @typedef {object} Setting
 * @property {string} group
 * @property {'text' | 'switch' | 'number' | 'choice' | 'choice-or-number' | 'choice-or-vector' | 'vector' | 'mask' | 'lamps'} kind
 * @property {UnitName} [unit]
 * @property {number} [min]          of a number, inclusive
 * @property {number} [max]
 * @property {number} [step]
 * @property {boolean} [whole]       a number without decimals
 * @property {boolean} [mayBeEmpty]  may be left out: what then counts follows from the rest
 * @property {readonly string[]} [choices]
 * @property {unknown} default       null: it is empty
 * @property {Readonly<Record<string, { min: number, max: number, step: number, default: number }>>} [parts]  of a lamp
 * @property {number} [most]         lamps
 */

)";

const char* nameOf(Setting::Kind kind) {
  switch (kind) {
    case Setting::Kind::Text:
      return "text";
    case Setting::Kind::Switch:
      return "switch";
    case Setting::Kind::Number:
      return "number";
    case Setting::Kind::Choice:
      return "choice";
    case Setting::Kind::ChoiceOrNumber:
      return "choice-or-number";
    case Setting::Kind::ChoiceOrVector:
      return "choice-or-vector";
    case Setting::Kind::Vector:
      return "vector";
    case Setting::Kind::Mask:
      return "mask";
    case Setting::Kind::Lamps:
      break;
  }
  return "lamps";
}

/// Ranges and defaults of the numbers of a lamp.
Json partsOfLamp() {
  Json parts = Json::object();
  for (const LampPart& part : lampParts())
    parts[std::string(part.key)] = {
        {"min", part.min}, {"max", part.max}, {"step", part.step}, {"default", DirectionalLight().*part.value}};
  return parts;
}

Json describe(const Setting& setting, const Json& defaults) {
  Json entry = {{"group", setting.group}, {"kind", nameOf(setting.kind)}};
  if (setting.unit != Unit::None) entry["unit"] = traitsOf(setting.unit).name;
  if (setting.takesNumber()) {
    entry["min"] = setting.min;
    entry["max"] = setting.max;
    entry["step"] = setting.step;
    if (setting.isWhole) entry["whole"] = true;
  }
  if (setting.mayBeEmpty) entry["mayBeEmpty"] = true;
  if (!setting.choices.empty()) entry["choices"] = setting.choices;
  entry["default"] = defaults.at(setting.key);
  if (setting.kind == Setting::Kind::Lamps) {
    entry["parts"] = partsOfLamp();
    entry["most"] = kMaxLights;
  }
  return entry;
}

/// Returns an object's entries as a constant of the module, one entry a line.
std::string constant(const char* name, const char* type, const Json& entries) {
  std::string text = fmt::format("/** @type {{{}}} */\nexport const {} = {{\n", type, name);
  for (const auto& [key, entry] : entries.items()) text += fmt::format("  {}: {},\n", key, entry.dump());
  return text + "};\n";
}

/// Returns quoted names as a type of the module.
std::string choiceType(const char* name, const std::vector<std::string_view>& names) {
  return fmt::format("/** @typedef {{'{}'}} {} */\n", fmt::join(names, "' | '"), name);
}

/// Returns the settings that each process implies.
Json processes() {
  Json all = Json::object();
  for (const auto& [name, printer] : namedPrinters())
    all[fmt::format("'{}'", name)] = {{"nozzleMm", printer.nozzleMm}, {"layerMm", printer.layerMm}};
  return all;
}

}  // namespace

std::string settingsModule() {
  const Json defaults = Json::parse(settingsJson(defaultRequest()));
  Json all = Json::object();
  std::vector<std::string_view> keys, unitNames;
  for (const Setting& setting : settings()) {
    all[setting.key] = describe(setting, defaults);
    keys.push_back(setting.key);
  }
  for (const UnitTraits& unit : units())
    if (!unit.name.empty()) unitNames.push_back(unit.name);
  return kModuleHead + choiceType("SettingKey", keys) + choiceType("UnitName", unitNames) + "\n" +
         constant("kSettings", "Readonly<Record<SettingKey, Setting>>", all) + "\n" +
         constant("kProcesses", "Readonly<Record<string, { nozzleMm: number, layerMm: number }>>", processes());
}

}  // namespace qrelief
