// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "base/message.h"

namespace qrelief {

/// Converts a message for reports and for the page, which makes the sentence itself:
///
///     {"code": "pocket-too-narrow", "values": {"pocket": {"lengthMm": 0.24}, "at": {"place": [1, 2, 3]}}}
///
/// The key of each value is its kind: count, index, number, lengthMm, angleDeg, fraction, place, extentMm, quoted,
/// term, setting, choice ({"key", "value"}), indices, cause (a message).
inline nlohmann::ordered_json jsonOf(const Message& message);

inline nlohmann::ordered_json jsonOf(const MessageValue& value) {
  using Kind = MessageValue::Kind;
  const auto single = [&](const char* kind) { return nlohmann::ordered_json{{kind, value.numbers[0]}}; };
  const auto integral = [&](const char* kind) {
    // A file may declare a count that no integer holds.
    constexpr double kExactBelow = 9007199254740992.0;  // 2^53
    const double n = value.numbers[0];
    if (std::abs(n) < kExactBelow) return nlohmann::ordered_json{{kind, static_cast<std::int64_t>(n)}};
    return single(kind);
  };
  switch (value.kind) {
    case Kind::Count:
      return integral("count");
    case Kind::Index:
      return integral("index");
    case Kind::Number:
      return single("number");
    case Kind::LengthMm:
      return single("lengthMm");
    case Kind::AngleDeg:
      return single("angleDeg");
    case Kind::Fraction:
      return single("fraction");
    case Kind::Place:
      return {{"place", value.numbers}};
    case Kind::ExtentMm:
      return {{"extentMm", value.numbers}};
    case Kind::Quoted:
      return {{"quoted", value.text}};
    case Kind::Term:
      return {{"term", value.text}};
    case Kind::Setting:
      return {{"setting", value.text}};
    case Kind::Choice:
      return {{"choice", {{"key", value.key}, {"value", value.text}}}};
    case Kind::Indices:
      return {{"indices", value.numbers}};
    case Kind::Cause:
      break;
  }
  return {{"cause", jsonOf(value.cause.front())}};
}

inline nlohmann::ordered_json jsonOf(const Message& message) {
  nlohmann::ordered_json values = nlohmann::ordered_json::object();
  for (const MessageValue& value : message.values) values[value.name] = jsonOf(value);
  return {{"code", message.code}, {"values", std::move(values)}};
}

}  // namespace qrelief
