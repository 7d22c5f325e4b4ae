// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/parse_number.h"

#include <algorithm>
#include <charconv>
#include <fast_float/fast_float.h>

namespace qrelief {
namespace {

/// Drops a plus sign, which the parsers do not know. A second sign stays, and they refuse it.
std::string_view withoutPlus(std::string_view token) {
  const bool isPlus = token.size() > 1 && token[0] == '+' && token[1] != '-' && token[1] != '+';
  return isPlus ? token.substr(1) : token;
}

/// Parses with a function like std::from_chars.
template <class Number, class FromChars>
std::optional<Number> parsed(std::string_view token, FromChars fromChars) {
  token = withoutPlus(token);
  Number value{};
  const auto [end, error] = fromChars(token.data(), token.data() + token.size(), value);
  if (error != std::errc() || end != token.data() + token.size()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> parseNumber(std::string_view token) {
  return parsed<double>(token, [](const char* first, const char* last, double& value) {
    return fast_float::from_chars(first, last, value);
  });
}

std::string_view withoutBlanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

std::optional<std::int64_t> parseInteger(std::string_view token) {
  return parsed<std::int64_t>(token, [](const char* first, const char* last, std::int64_t& value) {
    return std::from_chars(first, last, value);
  });
}

}  // namespace qrelief
