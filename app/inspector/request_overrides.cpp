// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/request_overrides.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "settings/engrave_request.h"

namespace qrelief {
namespace {

using Kind = Setting::Kind;

Tunable tunableOf(const Setting& setting, std::string key) {
  Tunable tunable;
  tunable.setting = &setting;
  tunable.key = std::move(key);
  tunable.min = setting.min, tunable.max = setting.max, tunable.step = setting.step;
  return tunable;
}

Tunable numberOf(const Setting& setting) {
  Tunable tunable = tunableOf(setting, setting.key);
  const bool isEmptyAtZero = setting.mayBeEmpty && !setting.otherwise;
  if (isEmptyAtZero) tunable.min = 0;
  tunable.read = [&setting](const EngraveRequest& request) {
    const SettingValue value = setting.read(request);
    const double* number = std::get_if<double>(&value);
    return number ? *number : setting.otherwise ? setting.otherwise(request) : 0;
  };
  tunable.write = [&setting, isEmptyAtZero](EngraveRequest& request, double value) {
    if (setting.isWhole) value = std::round(value);
    if (isEmptyAtZero && value <= 0)
      setting.write(request, {});
    else
      setting.write(request, std::max(value, setting.min));
  };
  return tunable;
}

Tunable switchOf(const Setting& setting) {
  Tunable tunable = tunableOf(setting, setting.key);
  tunable.isSwitch = true;
  tunable.read = [&setting](const EngraveRequest& request) { return std::get<bool>(setting.read(request)) ? 1 : 0; };
  tunable.write = [&setting](EngraveRequest& request, double value) { setting.write(request, value != 0); };
  return tunable;
}

/// Makes a tunable for a choice. A vector cannot be chosen, only taken over from the page.
Tunable choiceOf(const Setting& setting) {
  Tunable tunable = tunableOf(setting, setting.key);
  tunable.choices = setting.choices;
  if (setting.takesNumber()) tunable.choices.emplace_back("number");
  if (setting.takesVector()) tunable.choices.emplace_back("vector");
  tunable.min = 0, tunable.max = static_cast<double>(tunable.choices.size() - 1), tunable.step = 1;
  tunable.read = [&setting](const EngraveRequest& request) {
    const SettingValue value = setting.read(request);
    const std::string* name = std::get_if<std::string>(&value);
    const auto it = std::find(setting.choices.begin(), setting.choices.end(), name ? *name : std::string());
    return static_cast<double>(it - setting.choices.begin());
  };
  tunable.write = [&setting](EngraveRequest& request, double value) {
    const auto index = static_cast<std::size_t>(value);
    if (index < setting.choices.size())
      setting.write(request, setting.choices[index]);
    else if (setting.takesNumber() && !std::holds_alternative<double>(setting.read(request)))
      setting.write(request, setting.usual);
  };
  return tunable;
}

/// Makes the tunable for the number of a choice. It takes effect only while a number is chosen.
Tunable numberBesideChoice(const Setting& setting) {
  Tunable tunable = tunableOf(setting, setting.key + ".number");
  tunable.read = [&setting](const EngraveRequest& request) {
    const SettingValue value = setting.read(request);
    const double* number = std::get_if<double>(&value);
    return number ? *number : setting.usual;
  };
  tunable.write = [&setting](EngraveRequest& request, double value) {
    if (setting.isWhole) value = std::round(value);
    if (std::holds_alternative<double>(setting.read(request))) setting.write(request, value);
  };
  return tunable;
}

/// Makes the tunable for a part of a lamp. A missing lamp has strength 0.
Tunable partOfLamp(const Setting& setting, std::size_t lamp, const LampPart& part) {
  Tunable tunable = tunableOf(setting, fmt::format("{}.{}.{}", setting.key, lamp + 1, part.key));
  tunable.min = part.min, tunable.max = part.max, tunable.step = part.step;
  tunable.read = [lamp, part](const EngraveRequest& request) {
    static const DirectionalLight kOff = {.strength = 0};
    return (lamp < request.depth.lights.size() ? request.depth.lights[lamp] : kOff).*part.value;
  };
  tunable.write = [lamp, part](EngraveRequest& request, double value) {
    while (request.depth.lights.size() <= lamp) request.depth.lights.push_back({.strength = 0});
    request.depth.lights[lamp].*part.value = value;
  };
  return tunable;
}

std::vector<Tunable> makeTunables() {
  std::vector<Tunable> all;
  for (const Setting& setting : settings()) {
    if (setting.kind == Kind::Number) all.push_back(numberOf(setting));
    if (setting.kind == Kind::Switch) all.push_back(switchOf(setting));
    if (setting.takesChoice()) all.push_back(choiceOf(setting));
    if (setting.kind == Kind::ChoiceOrNumber) all.push_back(numberBesideChoice(setting));
    if (setting.kind != Kind::Lamps) continue;
    for (std::size_t lamp = 0; lamp < kMaxLights; ++lamp)
      for (const LampPart& part : lampParts()) all.push_back(partOfLamp(setting, lamp, part));
  }
  return all;
}

}  // namespace

std::span<const Tunable> tunables() {
  static const std::vector<Tunable> kAll = makeTunables();
  return kAll;
}

RequestOverrides::RequestOverrides() : values_(tunables().size()) {}

void RequestOverrides::set(std::size_t index, double value, const EngraveRequest& page) {
  const Tunable& tunable = tunables()[index];
  const double pages = tunable.read(page);
  if (!std::isfinite(value)) return;
  value = std::clamp(value, tunable.min, tunable.max);
  values_[index] = std::abs(value - pages) < 1e-6 ? std::optional<double>() : value;  // allows for floats that passed
                                                                                      // through doubles
}

void RequestOverrides::resetAll() { values_.assign(values_.size(), std::nullopt); }

std::size_t RequestOverrides::count() const {
  return static_cast<std::size_t>(std::count_if(values_.begin(), values_.end(), [](const auto& v) { return bool(v); }));
}

double RequestOverrides::valueOf(std::size_t index, const EngraveRequest& page) const {
  return values_[index].value_or(tunables()[index].read(page));
}

EngraveRequest RequestOverrides::appliedTo(EngraveRequest page) const {
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (values_[i]) tunables()[i].write(page, *values_[i]);
  std::erase_if(page.depth.lights, [](const DirectionalLight& light) { return light.strength == 0; });
  return page;
}

}  // namespace qrelief
