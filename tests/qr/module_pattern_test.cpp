// SPDX-License-Identifier: GPL-3.0-or-later
#include "qr/module_pattern.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace qrelief {
namespace {

constexpr ModulePattern kModulePatterns[] = {ModulePattern::None, ModulePattern::Square, ModulePattern::ThinPlus,
                                             ModulePattern::Diamond, ModulePattern::ThickPlus};
using Lines = std::vector<std::string>;

constexpr int kCarvedPerModule[] = {25, 9, 5, 13, 21};

Symbol exampleSymbol() {
  const Result<Symbol> symbol = encodeSymbol("https://example.com");
  EXPECT_TRUE(symbol);
  return symbol.value_or(Symbol{});
}

/// Returns the submodules of the modules in rows [top, top + rows), columns [left, left + columns), one string per
/// line.
Lines picture(const SubmoduleMask& mask, int top, int left, int rows, int columns) {
  Lines lines;
  for (int y = top * kSubmodulesPerModule; y < (top + rows) * kSubmodulesPerModule; ++y) {
    std::string line;
    for (int x = left * kSubmodulesPerModule; x < (left + columns) * kSubmodulesPerModule; ++x) {
      line += mask.at(y, x) ? '#' : '.';
    }
    lines.push_back(line);
  }
  return lines;
}

void floodFill(Lines& lines, std::size_t y, std::size_t x) {
  if (y >= lines.size() || x >= lines[y].size() || lines[y][x] != '#') return;
  lines[y][x] = '.';
  floodFill(lines, y + 1, x);
  floodFill(lines, y - 1, x);  // wraps round below 0 and is rejected
  floodFill(lines, y, x + 1);
  floodFill(lines, y, x - 1);
}

/// Counts the carved regions; submodules join along edges.
int countPieces(Lines lines) {
  int pieces = 0;
  for (std::size_t y = 0; y < lines.size(); ++y) {
    for (std::size_t x = 0; x < lines[y].size(); ++x) {
      if (lines[y][x] != '#') continue;
      ++pieces;
      floodFill(lines, y, x);
    }
  }
  return pieces;
}

long countCarved(const SubmoduleMask& mask) { return std::count(mask.begin(), mask.end(), 1); }

long countDark(const Symbol& symbol, bool finder) {
  long count = 0;
  for (std::size_t i = 0; i < symbol.dark.size(); ++i) {
    count += symbol.dark[i] != 0 && (symbol.roles[i] == ModuleRole::Finder) == finder;
  }
  return count;
}

TEST(ModulePattern, LooksAsInThePaper) {
  const Symbol symbol = exampleSymbol();
  const Lines expected[] = {{"#####", "#####", "#####", "#####", "#####"},
                            {".....", ".###.", ".###.", ".###.", "....."},
                            {".....", "..#..", ".###.", "..#..", "....."},
                            {"..#..", ".###.", "#####", ".###.", "..#.."},
                            {".###.", "#####", "#####", "#####", ".###."}};
  for (std::size_t p = 0; p < std::size(kModulePatterns); ++p) {
    const SubmoduleMask mask = submodulesToCarve(symbol, kModulePatterns[p], FinderPattern::None);
    EXPECT_EQ(picture(mask, 6, 8, 1, 1), expected[p]);        // the first dark module of the timing pattern
    EXPECT_EQ(picture(mask, 6, 9, 1, 1), Lines(5, "....."));  // the light one beside it
  }
}

TEST(ModulePattern, CarvesItsShareOfEveryDarkModule) {
  const Symbol symbol = exampleSymbol();
  for (std::size_t p = 0; p < std::size(kModulePatterns); ++p) {
    const SubmoduleMask mask = submodulesToCarve(symbol, kModulePatterns[p], FinderPattern::None);
    EXPECT_EQ(mask.rows(), 5 * symbol.size);
    EXPECT_EQ(mask.size(), static_cast<std::size_t>(mask.rows() * mask.rows()));
    EXPECT_EQ(countCarved(mask), kCarvedPerModule[p] * countDark(symbol, false) + 25 * countDark(symbol, true));
  }
}

TEST(ModuleMask, CarvesAPatternOfOnesOwn) {
  const auto mask = moduleMaskFromText("10000/11000/00100/00011/01010");
  ASSERT_TRUE(mask);
  const Symbol symbol = exampleSymbol();
  const Lines own = {"#....", "##...", "..#..", "...##", ".#.#."};
  EXPECT_EQ(picture(submodulesToCarve(symbol, *mask, FinderPattern::None), 6, 8, 1, 1), own);
  EXPECT_EQ(picture(submodulesToCarve(symbol, *mask, FinderPattern::None), 0, 0, 1, 1), Lines(5, "#####"));
  EXPECT_EQ(picture(submodulesToCarve(symbol, *mask, FinderPattern::AsModules), 0, 0, 1, 1), own);
}

TEST(ModuleMask, ReadsBackWhatItWrote) {
  for (const char* text : {"10000/11000/00100/00011/01010", "01111/11111/11111/11111/11111"})
    EXPECT_EQ(moduleMaskText(moduleMaskFromText(text).value_or(ModulePattern::None)), text);
  EXPECT_EQ(moduleMaskText(ModulePattern::Diamond), "00100/01110/11111/01110/00100");
  EXPECT_EQ(moduleMaskFromText("00100/01110/11111/01110/00100"), ModuleMask(ModulePattern::Diamond));
}

TEST(ModuleMask, RefusesEverythingButFiveRowsWithBothKinds) {
  for (const char* text :
       {"", "1", "00100/01110/11111/01110", "00100/01110/11111/01110/00100/", "0010001110111110111000100",
        "00100/01110/11111/01110/0010 ", "00100/01110/11121/01110/00100", "00100-01110-11111-01110-00100",
        "0010/001110/11111/01110/00100", "00000/00000/00000/00000/00000", "11111/11111/11111/11111/11111"})
    EXPECT_FALSE(moduleMaskFromText(text)) << text;
}

TEST(FinderPattern, TreatsEveryModuleTheSameWithoutFinderPatterns) {
  const Symbol symbol = exampleSymbol();
  for (std::size_t p = 0; p < std::size(kModulePatterns); ++p) {
    const SubmoduleMask mask = submodulesToCarve(symbol, kModulePatterns[p], FinderPattern::AsModules);
    EXPECT_EQ(countCarved(mask), kCarvedPerModule[p] * (countDark(symbol, false) + countDark(symbol, true)));
  }
}

TEST(FinderPattern, ShiftsTheSquareOfACornerTowardsTheCentre) {
  const Symbol symbol = exampleSymbol();
  EXPECT_EQ(picture(submodulesToCarve(symbol, ModulePattern::None, FinderPattern::Diamond), 0, 0, 2, 2),
            (Lines{".......#..",  //
                   "......###.",  //
                   "..########",  //
                   "..###.###.",  //
                   "..###..#..",  //
                   "..#.......",  //
                   ".###......",  //
                   "#####.....",  //
                   ".###......",  //
                   "..#......."}));
  EXPECT_EQ(picture(submodulesToCarve(symbol, ModulePattern::Square, FinderPattern::ThickPlus), 0, 0, 1, 2),
            (Lines{"......###.",  //
                   ".....#####",  //
                   "..########",  //
                   "..########",  //
                   "..###.###."}));
}

TEST(FinderPattern, IsTheSameInAllThreeFindersAndSymmetric) {
  const Symbol symbol = exampleSymbol();
  for (const FinderPattern finder : {FinderPattern::Diamond, FinderPattern::ThickPlus}) {
    const SubmoduleMask mask = submodulesToCarve(symbol, ModulePattern::ThinPlus, finder);
    const Lines topLeft = picture(mask, 0, 0, 7, 7);
    EXPECT_EQ(picture(mask, 0, symbol.size - 7, 7, 7), topLeft);
    EXPECT_EQ(picture(mask, symbol.size - 7, 0, 7, 7), topLeft);
    EXPECT_EQ(Lines(topLeft.rbegin(), topLeft.rend()), topLeft);
    for (std::size_t y = 0; y < topLeft.size(); ++y) {
      for (std::size_t x = 0; x < topLeft.size(); ++x) EXPECT_EQ(topLeft[y][x], topLeft[x][y]);
    }
  }
}

TEST(FinderPattern, CarvesItsShareOfEveryFinder) {
  const Symbol symbol = exampleSymbol();
  const long others = 9 * countDark(symbol, false);  // Square
  const auto carved = [&](FinderPattern finder) {
    return countCarved(submodulesToCarve(symbol, ModulePattern::Square, finder)) - others;
  };
  // A finder pattern has 24 + 9 dark modules; four of them take the nine submodules of a square.
  EXPECT_EQ(carved(FinderPattern::None), 3 * 33 * 25);
  EXPECT_EQ(carved(FinderPattern::AsModules), 3 * 33 * 9);
  EXPECT_EQ(carved(FinderPattern::Diamond), 3 * (29 * 13 + 4 * 9));
  EXPECT_EQ(carved(FinderPattern::ThickPlus), 3 * (29 * 21 + 4 * 9));
  EXPECT_EQ(carved(FinderPattern::ThickPlusSharp), 3 * 33 * 21);
}

TEST(FinderPattern, KeepsRingAndCentreInOnePieceEach) {
  const Symbol symbol = exampleSymbol();
  for (const FinderPattern finder : {FinderPattern::Diamond, FinderPattern::ThickPlus, FinderPattern::ThickPlusSharp}) {
    EXPECT_EQ(countPieces(picture(submodulesToCarve(symbol, ModulePattern::Square, finder), 0, 0, 7, 7)), 2);
  }
  const SubmoduleMask apart = submodulesToCarve(symbol, ModulePattern::Square, FinderPattern::AsModules);
  EXPECT_EQ(countPieces(picture(apart, 0, 0, 7, 7)), 33);
}

TEST(ModulePattern, HasTheNameOnTheCommandLine) {
  EXPECT_EQ(modulePatternName(ModulePattern::None), "none");
  EXPECT_EQ(modulePatternName(ModulePattern::Square), "square");
  EXPECT_EQ(modulePatternName(ModulePattern::ThinPlus), "thin-plus");
  EXPECT_EQ(modulePatternName(ModulePattern::Diamond), "diamond");
  EXPECT_EQ(modulePatternName(ModulePattern::ThickPlus), "thick-plus");
}

TEST(FinderPattern, HasTheNameOnTheCommandLine) {
  EXPECT_EQ(finderPatternName(FinderPattern::None), "none");
  EXPECT_EQ(finderPatternName(FinderPattern::AsModules), "as-modules");
  EXPECT_EQ(finderPatternName(FinderPattern::Diamond), "diamond");
  EXPECT_EQ(finderPatternName(FinderPattern::ThickPlus), "thick-plus");
  EXPECT_EQ(finderPatternName(FinderPattern::ThickPlusSharp), "thick-plus-sharp");
}

}  // namespace
}  // namespace qrelief
