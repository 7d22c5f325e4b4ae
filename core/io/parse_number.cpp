// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/parse_number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <clocale>
#include <cstdlib>
#include <limits>
#include <string>

namespace qrelief {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Largest exponent for which a double holds the power of ten exactly: 5^22 < 2^53.
constexpr int kMaxExactPower = 22;

constexpr std::array<double, kMaxExactPower + 1> kPowersOfTen = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                                 1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                                 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// Parses by strtod, which needs the locale's decimal point and a terminating zero.
double parseSlowly(std::string_view token) {
  std::string copy(token);
  if (const std::size_t point = copy.find('.'); point != std::string::npos)
    copy.replace(point, 1, std::localeconv()->decimal_point);
  return std::strtod(copy.c_str(), nullptr);
}

std::optional<double> parseSpecial(std::string_view word, bool negative) {
  const auto is = [word](std::string_view name) {
    return std::equal(word.begin(), word.end(), name.begin(), name.end(),
                      [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
  };
  const double sign = negative ? -1 : 1;
  if (is("nan")) return std::numeric_limits<double>::quiet_NaN();
  if (is("inf") || is("infinity")) return sign * std::numeric_limits<double>::infinity();
  return std::nullopt;
}

}  // namespace

std::optional<double> parseNumber(std::string_view token) {
  const char* p = token.data();
  const char* const end = p + token.size();
  bool negative = false;
  if (p != end && (*p == '-' || *p == '+')) negative = *p++ == '-';
  if (p != end && !isDigit(*p) && *p != '.') return parseSpecial({p, static_cast<std::size_t>(end - p)}, negative);

  std::uint64_t mantissa = 0;
  int significant = 0;  // digits in the mantissa, without leading zeros
  int exponent = 0;
  bool anyDigit = false;
  const auto takeDigits = [&](int exponentStep) {
    for (; p != end && isDigit(*p); ++p) {
      anyDigit = true;
      if (significant == 0 && *p == '0') {
        exponent += exponentStep;
      } else {
        ++significant;
        if (significant <= 19) mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p - '0');
        exponent += exponentStep;
      }
    }
  };
  takeDigits(0);
  if (p != end && *p == '.') {
    ++p;
    takeDigits(-1);
  }
  if (!anyDigit) return std::nullopt;
  if (p != end && (*p == 'e' || *p == 'E')) {
    ++p;
    bool negativeExponent = false;
    if (p != end && (*p == '-' || *p == '+')) negativeExponent = *p++ == '-';
    if (p == end) return std::nullopt;
    int written = 0;
    for (; p != end && isDigit(*p); ++p) written = std::min(written * 10 + (*p - '0'), 100'000);
    exponent += negativeExponent ? -written : written;
  }
  if (p != end) return std::nullopt;

  const double sign = negative ? -1 : 1;
  if (mantissa == 0 && significant == 0) return sign * 0.0;
  if (significant <= 19 && mantissa <= std::uint64_t{1} << 53 && std::abs(exponent) <= kMaxExactPower) {
    const double power = kPowersOfTen[static_cast<std::size_t>(std::abs(exponent))];
    const auto exact = static_cast<double>(mantissa);  // both operands exact: one rounding
    return sign * (exponent < 0 ? exact / power : exact * power);
  }
  return parseSlowly(token);
}

std::string_view withoutBlanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

std::optional<std::int64_t> parseInteger(std::string_view token) {
  if (token.size() > 1 && token[0] == '+' && isDigit(token[1])) token.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error != std::errc() || end != token.data() + token.size()) return std::nullopt;
  return value;
}

}  // namespace qrelief
