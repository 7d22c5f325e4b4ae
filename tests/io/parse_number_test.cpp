// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/parse_number.h"

#include <clocale>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>

namespace qrelief {
namespace {

TEST(ParseNumber, RoundsLikeStrtodForEveryLengthAndExponent) {
  std::uint64_t state = 1;
  const auto random = [&state] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return state >> 33;
  };
  for (int i = 0; i < 200'000; ++i) {
    std::string text = random() % 2 ? "-" : "";
    const auto whole = random() % 12;
    for (std::uint64_t d = 0; d < whole; ++d) text += static_cast<char>('0' + random() % 10);
    text += '.';
    const auto decimals = random() % 16 + (whole == 0 ? 1 : 0);
    for (std::uint64_t d = 0; d < decimals; ++d) text += static_cast<char>('0' + random() % 10);
    if (random() % 2) text += fmt::format("e{}", static_cast<int>(random() % 80) - 40);
    const std::optional<double> value = parseNumber(text);
    ASSERT_TRUE(value) << text;
    ASSERT_EQ(*value, std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(ParseNumber, RoundsHalfwayCasesAndExtremesCorrectly) {
  for (const char* text : {"9007199254740993", "9007199254740992.5", "2.2250738585072011e-308", "4.9e-324", "1e-400",
                           "1.7976931348623157e308", "1e23", "123456789012345678901234567890", "0.1e-22", "1e22"})
    EXPECT_EQ(*parseNumber(text), std::strtod(text, nullptr)) << text;
  EXPECT_TRUE(std::isinf(*parseNumber("1e400")));
  EXPECT_TRUE(std::isinf(*parseNumber("-1e999999999999")));
  EXPECT_EQ(*parseNumber("0e999999999999"), 0);
}

TEST(ParseNumber, KeepsTheSignOfZero) { EXPECT_TRUE(std::signbit(*parseNumber("-0.000"))); }

TEST(ParseNumber, AcceptsTheUsualSpellings) {
  EXPECT_EQ(*parseNumber("+1.5"), 1.5);
  EXPECT_EQ(*parseNumber(".5"), 0.5);
  EXPECT_EQ(*parseNumber("5."), 5);
  EXPECT_EQ(*parseNumber("1E+2"), 100);
  EXPECT_EQ(*parseNumber("00012"), 12);
}

TEST(ParseNumber, RefusesTextsThatAreNotNumbers) {
  for (const char* text :
       {"", "-", "+", ".", "e5", "1e", "1e+", "1,5", "1.2.3", "0x10", "1.5f", " 1", "1 ", "--1", "nano"})
    EXPECT_FALSE(parseNumber(text)) << text;
  EXPECT_FALSE(parseNumber(std::string_view("1\0", 2)));
}

TEST(ParseNumber, ReadsNanAndInfinitySoThatTheyCanBeReported) {
  EXPECT_TRUE(std::isnan(*parseNumber("NaN")));
  EXPECT_TRUE(std::isnan(*parseNumber("-nan")));
  EXPECT_EQ(*parseNumber("-Inf"), -INFINITY);
  EXPECT_EQ(*parseNumber("infinity"), INFINITY);
}

// This test is meaningful only where a locale with a decimal comma is installed.
TEST(ParseNumber, DoesNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", "fr_FR"})
    if (std::setlocale(LC_NUMERIC, name)) break;
  const double value = parseNumber("0.12345678901234567").value_or(0);  // more digits than the fast path takes
  std::setlocale(LC_NUMERIC, before.c_str());
  EXPECT_EQ(value, 0.12345678901234567);
}

TEST(ParseInteger, ReadsExactlyThe64BitRange) {
  EXPECT_EQ(*parseInteger("+12"), 12);
  EXPECT_EQ(*parseInteger("-9223372036854775808"), INT64_MIN);
  for (const char* text : {"", "-", "+", "+-1", "1.0", "9223372036854775808", "1a", " 1"})
    EXPECT_FALSE(parseInteger(text)) << text;
}

}  // namespace
}  // namespace qrelief
