// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/setting_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/parse_json.h"
#include "message_codes/settings_errors.h"
#include "settings/engrave_request.h"

namespace qrelief {
namespace {

using Json = nlohmann::ordered_json;
using Kind = Setting::Kind;

/// Returns a value as text that is short enough for a message.
std::string excerpt(const Json& value) {
  constexpr std::size_t kMaxShown = 40;
  const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() <= kMaxShown ? text : text.substr(0, kMaxShown - 1) + "…";
}

bool isFinite(const Json& value) { return value.is_number() && std::isfinite(value.get<double>()); }

std::optional<Vec3> vectorFrom(const Json& value) {
  if (!value.is_array() || value.size() != 3) return {};
  for (const Json& number : value)
    if (!isFinite(number)) return {};
  return Vec3(value[0].get<double>(), value[1].get<double>(), value[2].get<double>());
}

/// Reads a lamp; missing parts keep their defaults.
std::optional<DirectionalLight> lampFrom(const Json& value) {
  if (!value.is_object()) return {};
  DirectionalLight lamp;
  std::size_t known = 0;
  for (const LampPart& part : lampParts()) {
    const auto it = value.find(std::string(part.key));
    if (it == value.end()) continue;
    if (!isFinite(*it)) return {};
    lamp.*part.value = it->get<double>();
    ++known;
  }
  return known == value.size() ? std::optional(lamp) : std::nullopt;
}

std::optional<std::vector<DirectionalLight>> lampsFrom(const Json& value) {
  if (!value.is_array()) return {};
  std::vector<DirectionalLight> lamps;
  for (const Json& entry : value) {
    const auto lamp = lampFrom(entry);
    if (!lamp) return {};
    lamps.push_back(*lamp);
  }
  return lamps;
}

/// Reads a value; empty if the setting does not accept this kind.
std::optional<SettingValue> valueFrom(const Setting& setting, const Json& value) {
  if (value.is_boolean() && setting.kind == Kind::Switch) return value.get<bool>();
  if (isFinite(value) && setting.takesNumber()) return value.get<double>();
  if (value.is_string() && (setting.kind == Kind::Text || setting.kind == Kind::Mask || setting.takesChoice()))
    return value.get<std::string>();
  if (const auto vector = vectorFrom(value); vector && setting.takesVector()) return *vector;
  if (const auto lamps = lampsFrom(value); lamps && setting.kind == Kind::Lamps) return *lamps;
  return {};
}

Json jsonOf(const SettingValue& value) {
  if (const bool* on = std::get_if<bool>(&value)) return *on;
  if (const double* number = std::get_if<double>(&value)) return *number;
  if (const std::string* name = std::get_if<std::string>(&value)) return *name;
  if (const Vec3* vector = std::get_if<Vec3>(&value)) return Json::array({vector->x, vector->y, vector->z});
  const auto* lamps = std::get_if<std::vector<DirectionalLight>>(&value);
  if (!lamps) return nullptr;
  Json list = Json::array();
  for (const DirectionalLight& lamp : *lamps) {
    Json entry;
    for (const LampPart& part : lampParts()) entry[std::string(part.key)] = lamp.*part.value;
    list.push_back(entry);
  }
  return list;
}

}  // namespace

Result<EngraveRequest> requestFromJson(std::string_view json) {
  const Result<Json> parsed = parseJson(json);
  if (!parsed && parsed.error().message.code != "json-malformed")
    return fail(ErrorKind::BadUsage, parsed.error().message);
  if (!parsed || !parsed->is_object()) return fail(ErrorKind::BadUsage, message<"settings-no-object">());
  const Json& entries = *parsed;
  for (const auto& [key, value] : entries.items())
    if (!findSetting(key)) return fail(ErrorKind::BadUsage, message<"setting-unknown">(with::quoted<"key">(key)));
  EngraveRequest request = defaultRequest();
  for (const Setting& setting : settings()) {
    const auto it = entries.find(setting.key);
    if (it == entries.end() || it->is_null()) continue;
    const auto value = valueFrom(setting, *it);
    // An unknown choice also counts as the wrong kind, because there is nothing to write.
    const bool isName = value && std::holds_alternative<std::string>(*value);
    if (!value || (isName && !checkValue(setting, *value))) return tl::unexpected(wrongKind(setting, excerpt(*it)));
    setting.write(request, *value);
  }
  return request;
}

std::string settingsJson(const EngraveRequest& request) {
  Json all = Json::object();
  for (const Setting& setting : settings()) all[setting.key] = jsonOf(setting.read(request));
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace qrelief
