// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/ink.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "verification/grades.h"
#include "verification/reading_sweep.h"

namespace qrelief {
namespace {

TEST(Ink, ContrastIsTheDifferenceOfReflectances) {
  EXPECT_DOUBLE_EQ(Ink{}.contrast(), 0.8);
  EXPECT_DOUBLE_EQ((Ink{.dark = 0.9, .light = 0.1}).contrast(), 0.8);
  EXPECT_FALSE(Ink{}.isInverted());
  EXPECT_TRUE((Ink{.dark = 0.9, .light = 0.1}).isInverted());
}

TEST(InkMap, GivesEveryModuleItsOwnReflectanceAndTheSurroundingsTheBodys) {
  const Symbol symbol = *encodeSymbol("HELLO", {.version = 1});
  const double symbolMm = 2.0 * symbol.size;
  const InkMap map(symbol, symbolMm, {.dark = 0.2, .light = 0.8});
  for (int row = 0; row < symbol.size; ++row)
    for (int column = 0; column < symbol.size; ++column)
      for (const double inside : {0.01, 0.99}) {
        const Vec2 at(2 * (column + inside) - symbolMm / 2, symbolMm / 2 - 2 * (row + inside));
        ASSERT_FLOAT_EQ(map.factor(at), symbol.isDark(row, column) ? 0.25f : 1.0f) << row << ", " << column;
      }
  EXPECT_EQ(map.factor({-symbolMm / 2 - 0.01, symbolMm / 2 - 0.01}), 1);
}

TEST(InkMap, AppliesToPicturesAndSubmodulesOfAnyResolution) {
  const Symbol symbol = *encodeSymbol("HELLO", {.version = 1});
  for (const int pixels : {5, 7, 10}) {
    const int edge = pixels * (symbol.size + 2 * kPictureMarginModules);
    BottomUp<float> picture(edge, edge, 1);
    InkMap(symbol, symbol.size, {.dark = 0.1, .light = 0.8}).apply(picture, 1.0 / pixels);
    const ModuleReflectances measured = measureModules(symbol, submoduleMeans(picture, symbol.size, pixels));
    for (int row = 0; row < symbol.size; ++row)
      for (int column = 0; column < symbol.size; ++column)
        ASSERT_NEAR(measured.at(row, column), symbol.isDark(row, column) ? 0.125 : 1, 1e-6) << pixels;
  }
}

TEST(WithoutInversion, GradesAnInvertedCodeLikeTheSameCodeTheOtherWayRound) {
  const Symbol symbol = *encodeSymbol("HELLO", {.version = 1});
  const auto grade = [&](Ink ink) {
    const int edge = kBakedPixels * (symbol.size + 2 * kPictureMarginModules);
    BottomUp<float> picture(edge, edge, 1);
    InkMap(symbol, symbol.size, ink).apply(picture, 1.0 / kBakedPixels);
    return gradeSymbol(measureModules(symbol, withoutInversion(submoduleMeans(picture, symbol.size), ink)), ink.light);
  };
  EXPECT_EQ(grade({.dark = 0.05, .light = 0.85}).iso15415, 4);
  const SymbolGrades inverted = grade({.dark = 0.85, .light = 0.05});
  EXPECT_EQ(inverted.iso15415, 4);
  EXPECT_NEAR(inverted.symbolContrast.value, 0.8, 1e-5);
  EXPECT_EQ(grade({.dark = 0.5, .light = 0.8}).symbolContrast.grade, 1);  // D: 30 %
}

}  // namespace
}  // namespace qrelief
