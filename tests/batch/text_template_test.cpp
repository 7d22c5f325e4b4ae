// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/text_template.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace qrelief {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string filled(const char* text, const char* value) {
  const auto parsed = TextTemplate::parse(text);
  if (!parsed) return parsed.error().message.code;
  const auto result = parsed->filled([&](std::string_view) { return value; });
  return result ? *result : result.error().message.code;
}

TEST(TextTemplate, InsertsValues) {
  const auto parsed = TextTemplate::parse("https://example.org/{lot}/{n:05}?lot={lot}");
  ASSERT_TRUE(parsed);
  EXPECT_THAT(parsed->names(), ElementsAre("lot", "n"));
  const auto text = parsed->filled([](std::string_view name) { return name == "n" ? "42" : "A7"; });
  ASSERT_TRUE(text);
  EXPECT_EQ(*text, "https://example.org/A7/00042?lot=A7");
}

TEST(TextTemplate, PadsOnlyShortNumbersWithZeros) {
  EXPECT_EQ(filled("{n:03}", "7"), "007");
  EXPECT_EQ(filled("{n:03}", "1234"), "1234");
  EXPECT_EQ(filled("{n:03}", "x7"), "template-no-number");
  EXPECT_EQ(filled("{n:03}", ""), "template-no-number");
  EXPECT_EQ(filled("{n}", "x7"), "x7");
}

TEST(TextTemplate, ReadsDoubledBracesAsBraces) {
  EXPECT_EQ(filled("{{{n}}}", "7"), "{7}");
  EXPECT_EQ(filled(R"({{"id": "{n}"}})", "7"), R"({"id": "7"})");
}

TEST(TextTemplate, LeavesATextWithoutPlaceholdersUnchanged) {
  const auto parsed = TextTemplate::parse("same");
  ASSERT_TRUE(parsed);
  EXPECT_THAT(parsed->names(), IsEmpty());
  EXPECT_EQ(filled("", "7"), "");
}

TEST(TextTemplate, RefusesAnUnpairedBrace) {
  for (const char* text : {"{", "}", "{n", "n}", "{n}}", "{{n}", "{}", "{:05}", "{a{b}}", "{n:}", "{n:5}", "{n:0}",
                           "{n:0x}", "{n:099}", "{n:0000005}", "{n: 05}"})
    EXPECT_EQ(filled(text, "7"), "template-brace") << text;
}

}  // namespace
}  // namespace qrelief
