// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/text_scanner.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace qrelief {
namespace {

TEST(TextScanner, CountsLinesThatEndInLfCrLfOrCr) {
  TextScanner scanner("a\nb\r\nc\rd\n\ne");
  std::vector<std::size_t> lines;
  std::string words;
  for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word()) {
    words += word;
    lines.push_back(scanner.line());
  }
  EXPECT_EQ(words, "abcde");
  EXPECT_EQ(lines, (std::vector<std::size_t>{1, 2, 3, 4, 6}));
}

TEST(TextScanner, StaysOnTheLineOnRequest) {
  TextScanner scanner("  a\tb \nc");
  EXPECT_EQ(scanner.wordOnLine(), "a");
  EXPECT_EQ(scanner.wordOnLine(), "b");
  EXPECT_EQ(scanner.wordOnLine(), "");
  EXPECT_EQ(scanner.wordOnLine(), "");
  EXPECT_EQ(scanner.word(), "c");
  EXPECT_EQ(scanner.word(), "");
  EXPECT_TRUE(scanner.atEnd());
}

TEST(TextScanner, ReturnsTheRestOfALineWithoutItsLineEnding) {
  TextScanner scanner("a b c\r\nd");
  scanner.wordOnLine();
  EXPECT_EQ(scanner.restOfLine(), " b c");
  EXPECT_EQ(scanner.line(), 2u);
  EXPECT_EQ(scanner.restOfLine(), "d");
}

TEST(TextScanner, SkipsComments) {
  TextScanner scanner("# one\n1 2 # two\n# three", '#');
  EXPECT_EQ(scanner.word(), "1");
  EXPECT_EQ(scanner.word(), "2");
  EXPECT_EQ(scanner.word(), "");
}

TEST(TextScanner, EndsBeforePadding) {
  using namespace std::string_view_literals;
  for (const std::string_view text : {"a\n\0\0\0"sv, "a\n\x1A"sv, "a\n\0\n\0 \r\n"sv}) {
    TextScanner scanner(text);
    EXPECT_EQ(scanner.word(), "a");
    EXPECT_EQ(scanner.word(), "");
    EXPECT_TRUE(scanner.atEnd());
    EXPECT_EQ(scanner.line(), 2u);
  }
  EXPECT_EQ(TextScanner("a\0b"sv).word(), "a\0b"sv);
}

TEST(TextOf, DropsTheByteOrderMark) {
  const std::vector<std::uint8_t> bytes{0xEF, 0xBB, 0xBF, 'v', ' '};
  EXPECT_EQ(textOf(bytes), "v ");
}

}  // namespace
}  // namespace qrelief
