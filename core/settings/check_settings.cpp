// SPDX-License-Identifier: GPL-3.0-or-later
// Implements the checks of settings.h: the values that a setting accepts.
#include <cmath>

#include "message_codes/settings_errors.h"
#include "settings/engrave_request.h"
#include "settings/settings.h"

namespace qrelief {
namespace {

using Kind = Setting::Kind;

bool isWithin(double value, double min, double max) { return value >= min && value <= max; }  // false for NaN

template <ValueName kName>
NamedValue<kName> inUnit(Unit unit, double value) {
  return {with::numeric(kName.text, traitsOf(unit).kind, value)};
}

/// Checks a number of a setting, or of a part of one.
Status checkNumber(const std::string& key, Unit unit, double value, double min, double max) {
  if (isWithin(value, min, max)) return {};
  return fail(ErrorKind::BadUsage,
              message<"setting-out-of-range">(with::setting<"setting">(key), inUnit<"value">(unit, value),
                                              inUnit<"min">(unit, min), inUnit<"max">(unit, max)));
}

Status checkLamps(const Setting& setting, const std::vector<DirectionalLight>& lamps) {
  if (lamps.size() > kMaxLights)
    return fail(ErrorKind::BadUsage,
                message<"setting-too-many">(with::setting<"setting">(setting.key), with::count<"count">(lamps.size()),
                                            with::count<"max">(kMaxLights)));
  for (const DirectionalLight& lamp : lamps)
    for (const LampPart& part : lampParts())
      QRELIEF_TRY(checkNumber(setting.key, part.unit, lamp.*part.value, part.min, part.max));
  return {};
}

Status checkVector(const Setting& setting, const Vec3& vector) {
  const double length = glm::length(vector);
  if (length > 0 && std::isfinite(length)) return {};
  return fail(ErrorKind::BadUsage,
              message<"setting-no-length">(with::setting<"setting">(setting.key), with::place<"vector">(vector)));
}

/// Refuses settings that do not go together.
Status checkTogether(const EngraveRequest& request) {
  if (const Ink ink = request.marking.ink(); request.marking.isInColour() && ink.contrast() < kLeastInkContrast)
    return fail(ErrorKind::BadUsage,
                message<"colours-too-alike">(with::number<"dark">(ink.dark), with::number<"light">(ink.light),
                                             with::number<"least">(kLeastInkContrast)));
  if (request.code.isText() && !request.code.label.text.empty())
    return fail(ErrorKind::BadUsage,
                message<"text-alone-has-label">(with::setting<"label">("label"), with::setting<"content">("content"),
                                                with::choice<"value">("content", contentName(Content::Text))));
  if (request.isForOneLight() && request.lamps().size() > 1)
    return fail(ErrorKind::BadUsage,
                message<"one-light-has-several">(with::setting<"objective">("objective"),
                                                 with::choice<"value">("objective", "one-light"),
                                                 with::count<"count">(request.depth.lights.size())));
  return {};
}

std::string joined(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace

Status checkValue(const Setting& setting, const SettingValue& value) {
  if (const double* n = std::get_if<double>(&value); n && setting.takesNumber()) {
    QRELIEF_TRY(checkNumber(setting.key, setting.unit, *n, setting.min, setting.max));
    if (setting.isWhole && *n != std::floor(*n))
      return fail(ErrorKind::BadUsage,
                  message<"setting-not-whole">(with::setting<"setting">(setting.key), with::number<"value">(*n)));
    return {};
  }
  if (const std::string* name = std::get_if<std::string>(&value)) {
    const bool isKnown = setting.kind == Kind::Text || (setting.kind == Kind::Mask && moduleMaskFromText(*name)) ||
                         std::find(setting.choices.begin(), setting.choices.end(), *name) != setting.choices.end();
    return isKnown ? Status() : tl::unexpected(wrongKind(setting, *name));
  }
  if (const Vec3* vector = std::get_if<Vec3>(&value); vector && setting.takesVector())
    return checkVector(setting, *vector);
  if (const auto* list = std::get_if<std::vector<DirectionalLight>>(&value); list && setting.kind == Kind::Lamps)
    return checkLamps(setting, *list);
  if (std::holds_alternative<bool>(value) && setting.kind == Kind::Switch) return {};
  if (std::holds_alternative<std::monostate>(value) && setting.mayBeEmpty) return {};
  return tl::unexpected(wrongKind(setting, ""));
}

Status checkSettings(const EngraveRequest& request) {
  for (const Setting& setting : settings()) QRELIEF_TRY(checkValue(setting, setting.read(request)));
  QRELIEF_TRY(checkTogether(request));
  if (!request.print.process) return {};
  const auto process = processOf(request.print.printer);
  return process ? Status() : tl::unexpected(process.error());
}

template <class Part>
Status checkPart(Part EngraveRequest::*part, const Part& value) {
  EngraveRequest request = defaultRequest();
  request.*part = value;
  return checkSettings(request);
}

Status checkSettings(const PlacementRequest& placement) { return checkPart(&EngraveRequest::placement, placement); }
Status checkSettings(const MarkRequest& marking) { return checkPart(&EngraveRequest::marking, marking); }
Status checkSettings(const DepthRequest& depth) { return checkPart(&EngraveRequest::depth, depth); }
Status checkSettings(const PrinterRequest& print) { return checkPart(&EngraveRequest::print, print); }

Error wrongKind(const Setting& setting, std::string_view found) {
  const std::string choices = joined(setting.choices);
  switch (setting.kind) {
    case Kind::Text:
      return {ErrorKind::BadUsage,
              message<"setting-no-text">(with::setting<"setting">(setting.key), with::term<"found">(found))};
    case Kind::Switch:
      return {ErrorKind::BadUsage,
              message<"setting-no-switch">(with::setting<"setting">(setting.key), with::term<"found">(found))};
    case Kind::Number:
      return {ErrorKind::BadUsage,
              message<"setting-no-number">(with::setting<"setting">(setting.key), with::term<"found">(found))};
    case Kind::Choice:
      return {ErrorKind::BadUsage,
              message<"setting-no-choice">(with::setting<"setting">(setting.key), with::term<"found">(found),
                                           with::term<"choices">(choices))};
    case Kind::ChoiceOrNumber:
      return {ErrorKind::BadUsage,
              message<"setting-no-choice-or-number">(with::setting<"setting">(setting.key), with::term<"found">(found),
                                                     with::term<"choices">(choices))};
    case Kind::ChoiceOrVector:
      return {ErrorKind::BadUsage,
              message<"setting-no-choice-or-vector">(with::setting<"setting">(setting.key), with::term<"found">(found),
                                                     with::term<"choices">(choices))};
    case Kind::Vector:
      return {ErrorKind::BadUsage,
              message<"setting-no-vector">(with::setting<"setting">(setting.key), with::term<"found">(found))};
    case Kind::Mask:
      return {ErrorKind::BadUsage,
              message<"setting-no-mask">(with::setting<"setting">(setting.key), with::term<"found">(found))};
    case Kind::Lamps:
      break;
  }
  return {ErrorKind::BadUsage,
          message<"setting-no-lamps">(with::setting<"setting">(setting.key), with::term<"found">(found))};
}

}  // namespace qrelief
