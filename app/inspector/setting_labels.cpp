// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/setting_labels.h"

#include <fmt/format.h>

#include "inspector/translation.h"
#include "settings/engrave_request.h"

namespace qrelief {
namespace {

std::string worded(const std::string& key, const std::string& otherwise) {
  const char* words = translated(key.c_str());
  return words == key.c_str() ? otherwise : words;
}

std::string nameOf(const Tunable& tunable) { return worded("setting:" + tunable.key, tunable.key); }

/// Returns the unit. Parts of a lamp have units of their own, not the setting's.
Unit unitOf(const Tunable& tunable) {
  for (const LampPart& part : lampParts())
    if (tunable.setting->kind == Setting::Kind::Lamps && tunable.key.ends_with(part.key)) return part.unit;
  const bool isNumber = tunable.choices.empty() && !tunable.isSwitch;
  return isNumber ? tunable.setting->unit : Unit::None;
}

/// Returns the unit's label; empty if there is no unit.
std::string unitLabelOf(const Tunable& tunable) {
  const UnitTraits& unit = traitsOf(unitOf(tunable));
  return unit.name.empty() ? "" : worded(fmt::format("unit:{}", unit.name), std::string(unit.symbol));
}

}  // namespace

std::string labelOf(const Tunable& tunable) {
  const std::string unit = unitLabelOf(tunable);
  return nameOf(tunable) + (unit.empty() ? "" : ", ") + unit;
}

std::string groupLabelOf(const Setting& setting) { return worded("group:" + setting.group, setting.group); }

std::vector<std::string> choiceLabelsOf(const Tunable& tunable) {
  std::vector<std::string> labels;
  for (const std::string& choice : tunable.choices)
    labels.push_back(worded(fmt::format("choice:{}:{}", tunable.key, choice), choice));
  return labels;
}

std::string valueText(const Tunable& tunable, double value) {
  if (tunable.isSwitch) return translated(value != 0 ? "on" : "off");
  if (!tunable.choices.empty()) return choiceLabelsOf(tunable)[static_cast<std::size_t>(value)];
  return fmt::format("{:g}", value);
}

std::string describe(const RequestOverrides& overrides) {
  std::string text;
  for (std::size_t i = 0; i < tunables().size(); ++i) {
    if (!overrides.isSet(i)) continue;
    const Tunable& tunable = tunables()[i];
    const std::string unit = unitLabelOf(tunable);
    text += fmt::format("{}{} {}{}{}", text.empty() ? "" : ", ", nameOf(tunable),
                        valueText(tunable, overrides.valueOf(i, {})), unit.empty() || unit == "°" ? "" : " ", unit);
  }
  return text;
}

}  // namespace qrelief
