// SPDX-License-Identifier: GPL-3.0-or-later
#include "messages/sentences.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sstream>

#include "messages/words.h"
#include "settings/units.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;

/// Returns the words of all messages by code.
const Json& allWords() {
  static const Json kAll = [] {
    Json all = Json::object();
    for (const Json& part : Json::parse(messageWordsAsJson())) all.update(part);
    return all;
  }();
  return kAll;
}

/// The page writes numbers by the same rule (web/i18n/sentences.js); what nobody writes out has an exponent.
/// @param significant  digits, but never fewer than those before the decimal point
std::string digits(double value, int significant = 3) {
  constexpr double kLeastWrittenOut = 1e-6;
  constexpr double kMostWrittenOut = 1e15;
  const double size = std::abs(value);
  if (size == 0) return "0";
  if (!(size >= kLeastWrittenOut && size < kMostWrittenOut)) return fmt::format("{:.{}g}", value, significant);
  const int decimals = std::max(0, significant - 1 - static_cast<int>(std::floor(std::log10(size))));
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (decimals > 0) text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

/// As coordinates and unitless numbers of any size are read.
std::string general(double value) { return digits(value, 6); }

/// Returns 0 in place of a rounding error: less than a nanometre, or a millionth of a unit of the file.
double rounded(double value) { return std::abs(value) < 1e-6 ? 0 : value; }

std::string coordinate(double value) { return general(rounded(value)); }

std::string length(double mm, int significant) { return digits(rounded(mm), significant); }

std::string listed(const std::vector<double>& indices) {
  constexpr std::size_t kMostNamed = 6;
  std::string names;
  for (std::size_t i = 0; i < std::min(kMostNamed, indices.size()); ++i)
    names += fmt::format("{}{:.0f}", i == 0 ? "" : i + 1 == indices.size() ? " and " : ", ", indices[i]);
  return indices.size() > kMostNamed ? names + ", …" : names;
}

std::string written(const MessageValue& value, const Json& words) {
  using Kind = MessageValue::Kind;
  const std::vector<double>& n = value.numbers;
  switch (value.kind) {
    case Kind::Count:
    case Kind::Index:
      return fmt::format("{:.0f}", n[0]);
    case Kind::Number:
      return general(n[0]);
    case Kind::LengthMm:
      return lengthInWords(n[0]);
    case Kind::AngleDeg:
      return digits(rounded(n[0])) + "°";
    case Kind::Fraction:
      return fmt::format("{:.0f} %", 100 * n[0]);
    case Kind::Place:
      return fmt::format("({}, {}, {})", coordinate(n[0]), coordinate(n[1]), coordinate(n[2]));
    case Kind::ExtentMm:
      return extentInWords(n[0], n[1], n[2]);
    case Kind::Quoted:
      return fmt::format("\"{}\"", value.text);
    case Kind::Term:
    case Kind::Choice:
      return value.text;
    case Kind::Setting:
      return flagOf(value.text);
    case Kind::Indices:
      return listed(n);
    case Kind::Cause:
      break;
  }
  return sentence(value.cause.front(), words);
}

const MessageValue* find(const Message& message, std::string_view name) {
  const auto value =
      std::find_if(message.values.begin(), message.values.end(), [&](const MessageValue& v) { return v.name == name; });
  return value == message.values.end() ? nullptr : &*value;
}

/// Returns the text of a message's sentence or hint, the command's own if it has one.
/// @param what  "says" or "hint"
std::string templateOf(const Json& entry, const char* what, const Message& message) {
  const Json& own = entry.contains("command") ? entry.at("command") : entry;
  const Json& forms = own.contains(what) ? own.at(what) : entry.at(what);
  if (forms.is_string()) return forms.get<std::string>();
  const MessageValue* count = find(message, "count");
  return forms.at(count && count->numbers[0] == 1 ? "one" : "other").get<std::string>();
}

/// @param pattern  with `{name}` for values and `{@key}` for settings
std::string filled(const std::string& pattern, const Message& message, const Json& words) {
  std::string text;
  for (std::size_t begin = 0; begin < pattern.size();) {
    const std::size_t open = std::min(pattern.find('{', begin), pattern.size());
    text.append(pattern, begin, open - begin);
    if (open == pattern.size()) break;
    const std::size_t close = std::min(pattern.find('}', open), pattern.size() - 1);
    const std::string name = pattern.substr(open + 1, close - open - 1);
    const MessageValue* value = find(message, name);
    text += name.starts_with('@') ? flagOf(std::string_view(name).substr(1))
            : value               ? written(*value, words)
                                  : "{" + name + "}";
    begin = close + 1;
  }
  return text;
}

}  // namespace

std::string sentence(const Message& message) { return sentence(message, allWords()); }
std::string hint(const Message& message) { return hint(message, allWords()); }

std::string sentence(const Message& message, const Json& words) {
  const auto entry = words.find(message.code);
  if (entry != words.end()) return filled(templateOf(*entry, "says", message), message, words);
  std::ostringstream unworded;
  unworded << message;
  return unworded.str();
}

std::string hint(const Message& message, const Json& words) {
  const auto entry = words.find(message.code);
  if (entry != words.end() && entry->contains("hint"))
    return filled(templateOf(*entry, "hint", message), message, words);
  for (const MessageValue& value : message.values)
    if (value.kind == MessageValue::Kind::Cause) return hint(value.cause.front(), words);
  return {};
}

std::string sentenceAndHint(const Message& message) {
  const std::string helps = hint(message);
  return helps.empty() ? sentence(message) : fmt::format("{} ({})", sentence(message), helps);
}

std::string counted(std::size_t count, std::string_view one, std::string_view other) {
  return fmt::format("{} {}", count, count == 1 ? one : other);
}

std::string lengthInWords(double mm, int significant) { return length(mm, significant) + " mm"; }

std::string extentInWords(double xMm, double yMm, double zMm, int significant) {
  return fmt::format("{} × {} × {} mm", length(xMm, significant), length(yMm, significant), length(zMm, significant));
}

std::string durationInWords(double seconds) {
  return seconds < 90 ? fmt::format("{:.0f} s", seconds) : fmt::format("{:.0f} min", seconds / 60);
}

std::string flagOf(std::string_view key) {
  for (const UnitTraits& unit : units())
    if (key.ends_with(unit.keySuffix)) key.remove_suffix(unit.keySuffix.size());
  std::string flag = "--";
  for (const char c : key) {
    if (std::isupper(static_cast<unsigned char>(c))) flag += '-';
    flag += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return flag;
}

}  // namespace qrelief
