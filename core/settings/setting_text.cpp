// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/setting_text.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>

#include "base/unicode.h"

namespace qrelief {
namespace {

using Kind = Setting::Kind;

std::optional<double> numberFrom(const std::string& text) {
  try {
    std::size_t used = 0;
    const double value = std::stod(text, &used);
    if (used == text.size() && std::isfinite(value)) return value;
  } catch (const std::exception&) {
  }
  return {};
}

/// Parses numbers between commas; empty if one of them is not a number.
std::vector<double> numbersFrom(const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::optional<double> number = numberFrom(text.substr(begin, end - begin));
    if (!number) return {};
    numbers.push_back(*number);
    begin = end + 1;
  }
  return numbers;
}

std::optional<Vec3> vectorFrom(const std::string& text) {
  const std::vector<double> numbers = numbersFrom(text);
  if (numbers.size() != 3) return {};
  return Vec3(numbers[0], numbers[1], numbers[2]);
}

std::optional<std::vector<DirectionalLight>> lampsFrom(std::span<const std::string> texts) {
  std::vector<DirectionalLight> lamps;
  for (const std::string& text : texts) {
    const std::vector<double> numbers = numbersFrom(text);
    if (numbers.size() != 2 && numbers.size() != 3) return {};
    DirectionalLight& lamp = lamps.emplace_back();
    for (std::size_t i = 0; i < numbers.size(); ++i) lamp.*lampParts()[i].value = numbers[i];
  }
  return lamps;
}

/// Parses the texts; empty if the setting does not accept them.
std::optional<SettingValue> valueFrom(const Setting& setting, std::span<const std::string> texts) {
  if (setting.kind == Kind::Lamps) {
    const auto lamps = lampsFrom(texts);
    return lamps ? std::optional<SettingValue>(*lamps) : std::nullopt;
  }
  const std::string& text = texts.front();
  if (setting.kind == Kind::Text) return text;
  if (setting.kind == Kind::Switch) {
    const std::string word = caseFolded(text);
    if (word == "on" || word == "true" || word == "yes") return true;
    if (word == "off" || word == "false" || word == "no") return false;
    return {};
  }
  if ((setting.takesChoice() || setting.kind == Kind::Mask) && checkValue(setting, text)) return text;
  if (const auto vector = vectorFrom(text); vector && setting.takesVector()) return *vector;
  if (const auto number = numberFrom(text); number && setting.takesNumber()) return *number;
  return {};
}

}  // namespace

Result<SettingValue> valueFromText(const Setting& setting, std::span<const std::string> texts) {
  assert(!texts.empty());
  if (auto value = valueFrom(setting, texts)) return *value;
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "\"" : ", \"") + text + '"';
  return tl::unexpected(wrongKind(setting, list));
}

std::string valueText(const SettingValue& value) {
  if (const bool* on = std::get_if<bool>(&value)) return *on ? "on" : "off";
  if (const double* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  if (const std::string* name = std::get_if<std::string>(&value)) return *name;
  if (const Vec3* vector = std::get_if<Vec3>(&value)) return fmt::format("{},{},{}", vector->x, vector->y, vector->z);
  std::string list;
  if (const auto* lamps = std::get_if<std::vector<DirectionalLight>>(&value))
    for (const DirectionalLight& lamp : *lamps)
      list += fmt::format("{}{},{},{}", list.empty() ? "" : " ", lamp.azimuthDeg, lamp.elevationDeg, lamp.strength);
  return list;
}

}  // namespace qrelief
