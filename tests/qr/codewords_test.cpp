// SPDX-License-Identifier: GPL-3.0-or-later
#include "qr/codewords.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

namespace qrelief {
namespace {

constexpr ErrorCorrection kLevels[] = {ErrorCorrection::L, ErrorCorrection::M, ErrorCorrection::Q, ErrorCorrection::H};

/// Returns the product in GF(256) modulo x⁸ + x⁴ + x³ + x² + 1.
int product(int a, int b) {
  int result = 0;
  for (; b; b >>= 1, a = a << 1 ^ (a & 0x80 ? 0x11D : 0))
    if (b & 1) result ^= a;
  return result;
}

/// Evaluates the block as a polynomial at α^power.
int syndrome(const std::vector<std::uint8_t>& block, int power) {
  int x = 1;
  for (int i = 0; i < power; ++i) x = product(x, 2);
  int value = 0;
  for (const std::uint8_t codeword : block) value = product(value, x) ^ codeword;
  return value;
}

TEST(Codewords, EveryBlockOfEverySymbolIsAReedSolomonCodeword) {
  for (int version = 1; version <= 40; ++version) {
    for (const ErrorCorrection level : kLevels) {
      const auto symbol = encodeSymbol("QRELIEF", {.errorCorrection = level, .version = version});
      ASSERT_TRUE(symbol.has_value()) << version << errorCorrectionName(level);
      const CodewordLayout layout = layoutCodewords(*symbol);
      const auto blocks = readBlocks(*symbol, layout);
      ASSERT_EQ(blocks.size(), static_cast<std::size_t>(layout.structure.blocks));
      for (std::size_t b = 0; b < blocks.size(); ++b) {
        ASSERT_EQ(blocks[b].size(), static_cast<std::size_t>(layout.structure.codewordsOfBlock(static_cast<int>(b))));
        for (int power = 0; power < layout.structure.checkCodewords; ++power)
          ASSERT_EQ(syndrome(blocks[b], power), 0) << version << errorCorrectionName(level) << " block " << b;
      }
    }
  }
}

TEST(Codewords, EveryCodewordHasEightModules) {
  for (const int version : {1, 2, 7, 14, 32, 40}) {
    const auto symbol = encodeSymbol("A", {.version = version});
    ASSERT_TRUE(symbol.has_value());
    const CodewordLayout layout = layoutCodewords(*symbol);
    std::vector<int> count(static_cast<std::size_t>(layout.structure.codewords), 0);
    int remainder = 0;
    for (std::size_t i = 0; i < symbol->dark.size(); ++i) {
      if (layout.codewordOfModule[i] >= 0)
        ++count[static_cast<std::size_t>(layout.codewordOfModule[i])];
      else
        remainder += symbol->roles[i] == ModuleRole::Data;
    }
    EXPECT_TRUE(std::all_of(count.begin(), count.end(), [](int n) { return n == 8; })) << version;
    EXPECT_LT(remainder, 8) << version;
  }
}

TEST(Codewords, CorrectAsManyErrorsAsTheTableOfTheStandard) {
  // [ISO/IEC 18004, table 9]: (codewords, data, correctable) of a block.
  EXPECT_EQ(blockStructure(1, ErrorCorrection::L).correctable(), 2);
  EXPECT_EQ(blockStructure(1, ErrorCorrection::M).correctable(), 4);
  EXPECT_EQ(blockStructure(1, ErrorCorrection::H).correctable(), 8);
  EXPECT_EQ(blockStructure(2, ErrorCorrection::L).correctable(), 4);
  EXPECT_EQ(blockStructure(3, ErrorCorrection::L).correctable(), 7);
  EXPECT_EQ(blockStructure(3, ErrorCorrection::M).correctable(), 13);
  EXPECT_EQ(blockStructure(40, ErrorCorrection::H).correctable(), 15);
  EXPECT_EQ(blockStructure(5, ErrorCorrection::Q).codewords, 134);
  EXPECT_EQ(blockStructure(5, ErrorCorrection::Q).codewordsOfBlock(0), 33);
  EXPECT_EQ(blockStructure(5, ErrorCorrection::Q).codewordsOfBlock(3), 34);
}

}  // namespace
}  // namespace qrelief
