// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/parse_json.h"

#include <gtest/gtest.h>
#include <string>

namespace qrelief {
namespace {

std::string repeated(const std::string& piece, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += piece;
  return text;
}

std::string codeOf(const std::string& text) {
  const auto parsed = parseJson(text);
  return parsed ? "" : parsed.error().message.code;
}

TEST(ParseJson, AcceptsTheSameTextsAsTheLibrary) {
  const std::string text =
      R"({"b": [1, -2, 2.5, 18446744073709551615, true, null, "Ä\n"], "a": {"c": [], "d": {}, "": [[0]]}, "e": 1e300})";
  EXPECT_EQ(parseJson(text).value(), nlohmann::ordered_json::parse(text));
  EXPECT_EQ(parseJson(text)->dump(), nlohmann::ordered_json::parse(text).dump());
  for (const char* single : {"1", "\"x\"", "null", "[]", " {} "})
    EXPECT_EQ(parseJson(single).value(), nlohmann::ordered_json::parse(single)) << single;
}

TEST(ParseJson, ReportsTheByteWhereATextIsMalformed) {
  for (const char* text : {"", "{", "[1,]", "{\"a\" 1}", "{} {}", "\xff"})
    EXPECT_EQ(codeOf(text), "json-malformed") << text;
  EXPECT_EQ(parseJson("[1, x]").error().message.values.front().numbers[0], 5);
}

TEST(ParseJson, RefusesANumberBeyondAllFloats) { EXPECT_EQ(codeOf("[1e999]"), "json-number-too-large"); }

TEST(ParseJson, LimitsTheNestingDepth) {
  EXPECT_EQ(codeOf(repeated("[", kMaxJsonDepth) + repeated("]", kMaxJsonDepth)), "");
  EXPECT_EQ(codeOf(repeated("[", kMaxJsonDepth + 1) + repeated("]", kMaxJsonDepth + 1)), "json-too-deep");
  EXPECT_EQ(codeOf(repeated("{\"a\":", kMaxJsonDepth + 1)), "json-too-deep");
  EXPECT_EQ(codeOf(repeated("[", 1'000'000)), "json-too-deep");
}

TEST(ParseJson, RefusesADuplicateKey) {
  EXPECT_EQ(codeOf(R"({"a": 1, "b": 2, "a": 3})"), "json-key-twice");
  EXPECT_EQ(codeOf(R"([{"a": {"b": 1, "\u0062": 2}}])"), "json-key-twice");
  EXPECT_EQ(codeOf(R"({"a": {"a": 1}, "b": {"a": 1}})"), "");
}

}  // namespace
}  // namespace qrelief
