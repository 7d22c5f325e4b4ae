// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/break_up.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "qr/codewords.h"
#include "qr/sky_fraction.h"
#include "support/decode_symbol.h"

namespace qrelief::study {
namespace {

Symbol symbolOf(const SymbolOptions& options) {
  const Result<Symbol> symbol = encodeSymbol("https://qrelief.example/spot-1234", options);
  EXPECT_TRUE(symbol) << symbol.error().message;
  return symbol.value_or(Symbol());
}

Symbol brokenUp(Symbol symbol) {
  breakUpDarkAreas(symbol);
  return symbol;
}

int darkModules(const Symbol& symbol) {
  return static_cast<int>(std::count(symbol.dark.begin(), symbol.dark.end(), 1));
}

TEST(BreakUpDarkAreas, LeavesEachBlockAsMuchCorrectionAsLevelL) {
  for (const int version : {3, 5, 7, 12}) {
    for (const ErrorCorrection level : {ErrorCorrection::M, ErrorCorrection::Q, ErrorCorrection::H}) {
      const Result<Symbol> plain = encodeSymbol("QRELIEF", {.errorCorrection = level, .version = version});
      ASSERT_TRUE(plain);
      const Symbol broken = brokenUp(*plain);
      // Compares the reported reserve with the number of codewords that differ.
      const CodewordLayout layout = layoutCodewords(*plain);
      const auto before = readBlocks(*plain, layout), after = readBlocks(broken, layout);
      int most = 0;
      for (std::size_t b = 0; b < before.size(); ++b) {
        int wrong = 0;
        for (std::size_t i = 0; i < before[b].size(); ++i) wrong += before[b][i] != after[b][i];
        most = std::max(most, wrong);
      }
      const CorrectionReserve reserve = correctionReserve(broken);
      EXPECT_EQ(reserve.spent, most);
      EXPECT_GT(reserve.spent, 0);
      const BlockStructure least = blockStructure(version, ErrorCorrection::L);
      EXPECT_GE((reserve.correctable - reserve.spent) * layout.structure.blocks, least.correctable() * least.blocks);
      EXPECT_EQ(darkModules(*plain) - darkModules(broken), reserve.flippedModules);
    }
  }
}

TEST(BreakUpDarkAreas, MakesOnlyDataModulesLightAndLessSkySeen) {
  const Symbol plain = symbolOf({.errorCorrection = ErrorCorrection::H});
  const Symbol broken = brokenUp(plain);
  for (std::size_t i = 0; i < plain.dark.size(); ++i) {
    if (broken.dark[i] == plain.dark[i]) continue;
    EXPECT_EQ(plain.dark[i], 1);
    EXPECT_EQ(plain.roles[i], ModuleRole::Data);
    EXPECT_EQ(broken.flipped[i], 1);
  }
  EXPECT_LT(SkyFraction(broken).mean(broken), SkyFraction(plain).mean(plain));
}

TEST(BreakUpDarkAreas, ChangesNothingWithLevelL) {
  // The blocks are equal; only remainder bits may differ, which no decoder reads.
  const Symbol symbol = symbolOf({.errorCorrection = ErrorCorrection::L});
  const CodewordLayout layout = layoutCodewords(symbol);
  EXPECT_EQ(readBlocks(brokenUp(symbol), layout), readBlocks(symbol, layout));
}

TEST(BreakUpDarkAreas, ADecoderRestoresTheFlippedModules) {
  for (const int version : {2, 3, 6, 10, 20, 40}) {
    for (const ErrorCorrection level : {ErrorCorrection::M, ErrorCorrection::Q, ErrorCorrection::H}) {
      const Result<Symbol> plain = encodeSymbol("QRELIEF", {.errorCorrection = level, .version = version});
      ASSERT_TRUE(plain);
      EXPECT_EQ(decodeSymbol(brokenUp(*plain)).text(), "QRELIEF") << version << errorCorrectionName(level);
    }
  }
}

}  // namespace
}  // namespace qrelief::study
