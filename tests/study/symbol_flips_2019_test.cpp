// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/symbol_flips_2019.h"

#include <algorithm>
#include <gmock/gmock.h>

#include "qr/codewords.h"
#include "study/methods/break_up.h"
#include "support/symbols.h"

namespace qrelief::study {
namespace {

/// Returns a symbol of data modules from rows of '#' and '.'.
Symbol drawn(const std::vector<std::string>& rows) {
  Symbol symbol = lightSymbol(static_cast<int>(rows.size()));
  for (int row = 0; row < symbol.size; ++row)
    for (int column = 0; column < symbol.size; ++column) symbol.dark.at(row, column) = rows[row][column] == '#';
  return symbol;
}

Symbol levelH() {
  SymbolOptions options;
  options.version = 3;
  options.errorCorrection = ErrorCorrection::H;
  return *encodeSymbol("https://example.org/p/1", options);
}

TEST(SymbolFlips2019, VisibleAreaIsTheDarkAreaThatTheModuleSees) {
  EXPECT_NEAR(visibleArea2019(drawn({"...", ".#.", "..."}), 1, 1), 1, 0.001);
  EXPECT_NEAR(visibleArea2019(drawn({"...", "##.", "..."}), 1, 0), 2, 0.001);
  EXPECT_NEAR(visibleArea2019(drawn({"###", "###", "###"}), 1, 1), 9, 0.01);
  // Around the corner of an L the last module is half hidden: the ray from (0.5, 0.5) past (1, 1) meets x + y = 2.
  EXPECT_NEAR(visibleArea2019(drawn({"##.", ".#.", "..."}), 0, 0), 2.5, 0.001);
}

TEST(SymbolFlips2019, BudgetIsHalfTheDifferenceOfLevelsHAndL) {
  // In version 3, H has 2 blocks of 22 check codewords, L one of 15.
  EXPECT_EQ(flipBudget2019(levelH()), (2 * 22 - 15) / 2 / 2);
  SymbolOptions options;
  options.version = 3;
  options.errorCorrection = ErrorCorrection::L;
  EXPECT_EQ(flipBudget2019(*encodeSymbol("https://example.org/p/1", options)), 0);
}

TEST(SymbolFlips2019, SpendsTheBudgetOfEveryBlockAndNoMore) {
  Symbol symbol = levelH();
  const Symbol before = symbol;
  flipModules2019(symbol);
  const CodewordLayout layout = layoutCodewords(symbol);
  std::vector<int> spent(static_cast<std::size_t>(layout.structure.blocks), 0);
  for (std::size_t i = 0; i < layout.isSpoilt.size(); ++i)
    spent[static_cast<std::size_t>(layout.blockOfCodeword[i])] += layout.isSpoilt[i];
  EXPECT_THAT(spent, testing::Each(flipBudget2019(before)));
  EXPECT_LE(correctionReserve(symbol).spent, correctionReserve(symbol).correctable);
  for (std::size_t i = 0; i < symbol.dark.size(); ++i) {
    EXPECT_EQ(symbol.dark[i], before.dark[i] && !symbol.flipped[i]);
    EXPECT_TRUE(!symbol.flipped[i] || symbol.roles[i] == ModuleRole::Data);
  }
}

TEST(SymbolFlips2019, FurtherModulesOfADamagedCodewordAreFree) {
  Symbol symbol = levelH();
  flipModules2019(symbol);
  EXPECT_GT(std::count(symbol.flipped.begin(), symbol.flipped.end(), 1), 2 * flipBudget2019(levelH()));
}

}  // namespace
}  // namespace qrelief::study
