// SPDX-License-Identifier: GPL-3.0-or-later
#include "qr/segmentation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <string>

namespace qrelief {
namespace {

int bitsOf(const std::string& text, int version) { return segmentBits(segmentText(text, version), version); }

bool writable(char c, SegmentMode mode) {
  const std::string alphanumeric = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ $%*+-./:";
  if (mode == SegmentMode::Byte) return true;
  if (mode == SegmentMode::Alphanumeric) return alphanumeric.find(c) != std::string::npos;
  return c >= '0' && c <= '9';
}

/// Returns the fewest bits over every assignment of modes to characters.
int fewestBitsByBruteForce(const std::string& text, int version) {
  int fewest = std::numeric_limits<int>::max();
  const int ways = static_cast<int>(std::pow(3, text.size()));
  for (int way = 0; way < ways; ++way) {
    std::vector<Segment> segments;
    bool possible = true;
    int rest = way;
    for (std::size_t i = 0; i < text.size() && possible; ++i, rest /= 3) {
      const auto mode = static_cast<SegmentMode>(rest % 3);
      possible = writable(text[i], mode);
      if (segments.empty() || segments.back().mode != mode) segments.push_back({mode, i, 0});
      ++segments.back().length;
    }
    if (possible) fewest = std::min(fewest, segmentBits(segments, version));
  }
  return fewest;
}

TEST(Segmentation, CountsTheBitsOfEachModeAsTheStandardDoes) {
  EXPECT_EQ(bitsOf("01234567", 1), 4 + 10 + 10 + 10 + 7);  // the standard's example in annex I
  EXPECT_EQ(bitsOf("0123456789", 10), 4 + 12 + 30 + 4);
  EXPECT_EQ(bitsOf("AC-42", 1), 4 + 9 + 11 + 11 + 6);  // the standard's example for the alphanumeric mode
  EXPECT_EQ(bitsOf("AC-42", 27), 4 + 13 + 11 + 11 + 6);
  EXPECT_EQ(bitsOf("ab", 1), 4 + 8 + 16);
  EXPECT_EQ(bitsOf("ab", 10), 4 + 16 + 16);
  EXPECT_EQ(bitsOf("", 1), 0);
}

TEST(Segmentation, CoversTheTextInOrderWithoutNeighboursOfTheSameMode) {
  const std::string text = "see HTTPS://EXAMPLE.COM/0123456789012345 caf\xc3\xa9 0042 ABCDEFGHIJK";
  for (const int version : {1, 10, 27}) {
    std::size_t end = 0;
    const auto segments = segmentText(text, version);
    for (std::size_t s = 0; s < segments.size(); ++s) {
      EXPECT_EQ(segments[s].begin, end);
      EXPECT_GE(segments[s].length, 1u);
      if (s > 0) {
        EXPECT_NE(segments[s].mode, segments[s - 1].mode);
      }
      for (std::size_t i = 0; i < segments[s].length; ++i) EXPECT_TRUE(writable(text[end + i], segments[s].mode));
      end += segments[s].length;
    }
    EXPECT_EQ(end, text.size());
  }
}

TEST(Segmentation, FindsTheFewestBits) {
  const std::string characters = "0129AZ:a";
  std::uint32_t state = 12345;
  for (int round = 0; round < 60; ++round) {
    std::string text;
    const std::size_t length = 1 + static_cast<std::size_t>(round) % 9;
    for (std::size_t i = 0; i < length; ++i) {
      state = state * 1664525u + 1013904223u;
      text += characters[(state >> 24) % characters.size()];
    }
    for (const int version : {1, 10, 27}) {
      EXPECT_EQ(bitsOf(text, version), fewestBitsByBruteForce(text, version)) << text << " in version " << version;
    }
  }
}

TEST(Segmentation, SwitchesOnlyWhereTheSavingPaysForTheHeader) {
  // In versions 1 to 9, four digits cost 4 + 10 + 14 bits as their own segment and 32 as bytes; two cost 21 and 16.
  EXPECT_EQ(segmentText("abc12", 1).size(), 1u);
  EXPECT_EQ(segmentText("abc1234", 1).size(), 2u);
}

}  // namespace
}  // namespace qrelief
