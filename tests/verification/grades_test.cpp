// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/grades.h"

#include <gtest/gtest.h>

#include "qr/codewords.h"

namespace qrelief {
namespace {

class SymbolGradesTest : public testing::Test {
 protected:
  void SetUp() override {
    auto symbol = encodeSymbol("https://qrelief.example/12345678", {.version = 3});
    ASSERT_TRUE(symbol.has_value());
    symbol_ = std::move(*symbol);
  }

  ModuleReflectances ideal(double light, double dark) const {
    const int edge = symbol_.size + 2 * kQuietZoneModules;
    ModuleReflectances measured{&symbol_, {edge, edge, light}};
    for (int row = 0; row < symbol_.size; ++row)
      for (int column = 0; column < symbol_.size; ++column)
        if (symbol_.isDark(row, column)) set(measured, row, column, dark);
    return measured;
  }

  static void set(ModuleReflectances& measured, int row, int column, double value) {
    measured.values.at(row + kQuietZoneModules, column + kQuietZoneModules) = value;
  }

  /// Gives one module in each of `count` codewords of block 0 the value `light` if it is dark and `dark` if it is
  /// light.
  void spoil(ModuleReflectances& measured, int count, double light, double dark) const {
    const CodewordLayout layout = layoutCodewords(symbol_);
    for (int codeword = 0; codeword < layout.structure.codewords && count > 0; ++codeword) {
      if (layout.blockOfCodeword[static_cast<std::size_t>(codeword)] != 0) continue;
      for (int i = 0; i < symbol_.size * symbol_.size; ++i) {
        if (layout.codewordOfModule[i] != codeword) continue;
        set(measured, i / symbol_.size, i % symbol_.size, symbol_.dark[i] ? light : dark);
        break;
      }
      --count;
    }
  }

  Symbol symbol_;
};

TEST_F(SymbolGradesTest, BlackOnWhiteIsBestInEverything) {
  const SymbolGrades grades = gradeSymbol(ideal(0.9, 0.05), 1);
  EXPECT_DOUBLE_EQ(grades.symbolContrast.value, 0.85);
  EXPECT_DOUBLE_EQ(grades.modulation.value, 1);
  EXPECT_NEAR(grades.cellContrast.value, 0.85 / 0.9, 1e-12);
  EXPECT_EQ(grades.unusedCorrection.value, 1);
  EXPECT_EQ(grades.iso15415, 4);
  EXPECT_EQ(grades.iso29158, 4);
}

TEST_F(SymbolGradesTest, AModuleIsMisreadIfItIsCloserToTheOtherColour) {
  ModuleReflectances measured = ideal(0.9, 0.1);
  EXPECT_EQ(misreadModules(measured), Grid<std::uint8_t>(symbol_.size, symbol_.size));
  ASSERT_TRUE(symbol_.isDark(0, 3));
  ASSERT_FALSE(symbol_.isDark(1, 3));
  set(measured, 0, 3, 0.8);
  set(measured, 1, 3, 0.2);
  Grid<std::uint8_t> expected(symbol_.size, symbol_.size);
  expected.at(0, 3) = expected.at(1, 3) = 1;
  EXPECT_EQ(misreadModules(measured), expected);
}

TEST_F(SymbolGradesTest, ContrastIsGradedByTheStandardsBounds) {
  for (const auto& [dark, sc, cc] : {std::tuple{0.29, 4, 4},
                                     {0.31, 3, 4},
                                     {0.46, 2, 4},
                                     {0.61, 1, 4},
                                     {0.72, 1, 3},
                                     {0.78, 1, 2},
                                     {0.79, 1, 2},
                                     {0.84, 0, 1},
                                     {0.86, 0, 0}}) {
    const SymbolGrades grades = gradeSymbol(ideal(1, dark), 1);
    EXPECT_EQ(grades.symbolContrast.grade, sc) << dark;
    EXPECT_EQ(grades.cellContrast.grade, cc) << dark;
    EXPECT_EQ(grades.iso15415, sc) << dark;
    EXPECT_EQ(grades.iso29158, cc) << dark;
  }
}

TEST_F(SymbolGradesTest, ADarkerMaterialHasLessSymbolContrastButTheSameCellContrast) {
  const SymbolGrades white = gradeSymbol(ideal(1, 0.6), 1), grey = gradeSymbol(ideal(1, 0.6), 0.5);
  EXPECT_DOUBLE_EQ(grey.symbolContrast.value, white.symbolContrast.value / 2);
  EXPECT_DOUBLE_EQ(grey.cellContrast.value, white.cellContrast.value);
}

TEST_F(SymbolGradesTest, WrongCodewordsUseUpErrorCorrection) {
  const int correctable = blockStructure(3, ErrorCorrection::M).correctable();
  for (const auto& [wrong, grade] : {std::pair{0, 4}, {4, 4}, {6, 3}, {8, 2}, {9, 1}, {10, 0}}) {
    ModuleReflectances measured = ideal(1, 0.2);
    spoil(measured, wrong, 1, 0.2);
    const SymbolGrades grades = gradeSymbol(measured, 1);
    EXPECT_DOUBLE_EQ(grades.unusedCorrection.value, 1 - static_cast<double>(wrong) / correctable);
    EXPECT_EQ(grades.unusedCorrection.grade, grade) << wrong;
    EXPECT_EQ(grades.decode.grade, 4) << wrong;
  }
  ModuleReflectances broken = ideal(1, 0.2);
  spoil(broken, correctable + 1, 1, 0.2);
  EXPECT_EQ(gradeSymbol(broken, 1).decode.grade, 0);
  EXPECT_EQ(gradeSymbol(broken, 1).iso29158, 0);
}

TEST_F(SymbolGradesTest, ErrorCorrectionToleratesAFewWeakModules) {
  ModuleReflectances measured = ideal(1, 0.2);
  spoil(measured, 3, 0.66, 0.54);  // weak, but on their own side (dark < 0.6 < light) or just over it
  const SymbolGrades few = gradeSymbol(measured, 1);
  EXPECT_LT(few.modulation.value, 0.2);
  EXPECT_EQ(few.modulation.grade, 4);
  spoil(measured, 13, 0.66, 0.54);
  EXPECT_EQ(gradeSymbol(measured, 1).modulation.grade, 0);
}

TEST_F(SymbolGradesTest, EachWrongModuleOfAFinderPatternCostsAGrade) {
  ModuleReflectances measured = ideal(1, 0.2);
  for (int wrong = 1; wrong <= 4; ++wrong) {
    set(measured, 0, wrong - 1, 1);
    EXPECT_EQ(gradeSymbol(measured, 1).fixedPatternDamage.grade, 4 - wrong);
  }
}

TEST_F(SymbolGradesTest, WrongBitsOfOneCopyOfTheFormatCountHalf) {
  ModuleReflectances measured = ideal(1, 0.2);
  set(measured, 8, 0, symbol_.isDark(8, 0) ? 1 : 0.2);
  set(measured, 8, 1, symbol_.isDark(8, 1) ? 1 : 0.2);
  const SymbolGrades grades = gradeSymbol(measured, 1);
  EXPECT_EQ(grades.formatInformation.value, 2);
  EXPECT_EQ(grades.formatInformation.grade, 3);
}

TEST_F(SymbolGradesTest, TheApertureIsTheMiddleOfAModule) {
  const int edge = symbol_.size + 2 * kQuietZoneModules;
  Grid<double> submodules(5 * edge, 5 * edge, 1);
  for (int k = 0; k < 25; ++k)
    if (k % 5 >= 1 && k % 5 <= 3 && k / 5 >= 1 && k / 5 <= 3) submodules.at(4 * 5 + k / 5, 4 * 5 + k % 5) = 0;
  const ModuleReflectances measured = measureModules(symbol_, submodules);
  EXPECT_DOUBLE_EQ(measured.at(0, 0), 1 - 9.0 / 16);
  EXPECT_DOUBLE_EQ(measured.at(0, 1), 1);
}

}  // namespace
}  // namespace qrelief
