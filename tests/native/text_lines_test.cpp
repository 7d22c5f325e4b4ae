// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/text_lines.h"

#include <gtest/gtest.h>
#include <sstream>

namespace qrelief {
namespace {

/// Endless stream of one letter that counts how much was read.
class Endless : public std::streambuf {
 public:
  std::size_t taken = 0;

 protected:
  int_type underflow() override {
    taken += block_.size();
    setg(block_.data(), block_.data(), block_.data() + block_.size());
    return traits_type::to_int_type(block_.front());
  }

 private:
  std::string block_ = std::string(4096, 'x');
};

std::string textOf(const Result<std::vector<std::uint8_t>>& bytes) {
  return bytes ? std::string(bytes->begin(), bytes->end()) : bytes.error().message.code;
}

TEST(ReadText, ReadsAWholeText) {
  for (const std::string text : {"", "a", "ab\ncd\r\nef\rgh", "\n\n"}) {
    std::istringstream stream(text);
    EXPECT_EQ(textOf(readText(stream, 2)), text);
  }
  const std::string large(200'000, '\n');
  std::istringstream stream(large);
  EXPECT_EQ(textOf(readText(stream, 2)), large);
}

TEST(ReadText, RefusesATooLongLineByNumber) {
  std::istringstream stream("ab\r\ncd\n\refg");
  const auto read = readText(stream, 2);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message.code, "list-line-too-long");
  EXPECT_EQ(read.error().message.values[0].numbers[0], 4);
}

TEST(ReadText, ReadsNoMoreOfALineThanTheLimit) {
  Endless endless;
  std::istream stream(&endless);
  EXPECT_EQ(textOf(readText(stream, 100'000)), "list-line-too-long");
  EXPECT_LT(endless.taken, 200'000u);
}

TEST(LineReader, ContinuesAfterATooLongLine) {
  std::istringstream stream("ab\n\nabcdef\nfg\nabc");
  LineReader lines(stream, 2);
  EXPECT_EQ(lines.next()->value(), "ab");
  EXPECT_EQ(lines.next()->value(), "");
  EXPECT_EQ(lines.next()->error().message.values[0].numbers[0], 3);
  EXPECT_EQ(lines.next()->value(), "fg");
  EXPECT_FALSE(lines.next()->has_value());
  EXPECT_FALSE(lines.next());
}

TEST(LineReader, RefusesALineOnceItIsTooLong) {
  Endless endless;
  std::istream stream(&endless);
  LineReader lines(stream, 100'000);
  EXPECT_FALSE(lines.next()->has_value());
  EXPECT_LT(endless.taken, 200'000u);
}

}  // namespace
}  // namespace qrelief
