// SPDX-License-Identifier: GPL-3.0-or-later
#include "qr/symbol_shaping.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "qr/codewords.h"
#include "qr/sky_fraction.h"
#include "support/symbols.h"

namespace qrelief {
namespace {

constexpr ErrorCorrection kLevels[] = {ErrorCorrection::L, ErrorCorrection::M, ErrorCorrection::Q, ErrorCorrection::H};

Symbol symbolOf(const SymbolOptions& options) {
  const Result<Symbol> symbol = encodeSymbol("https://qrelief.example/spot-1234", options);
  EXPECT_TRUE(symbol) << symbol.error().message;
  return symbol.value_or(Symbol());
}

TEST(SymbolMask, ChangesToAnotherMaskAndBack) {
  for (int version = 1; version <= 40; ++version) {
    for (const ErrorCorrection level : kLevels) {
      const Result<Symbol> symbol = encodeSymbol("QRELIEF", {.errorCorrection = level, .version = version});
      ASSERT_TRUE(symbol);
      // Changing the mask and back writes every module of data and format twice.
      const Symbol other = withMask(*symbol, (symbol->mask + 3) % 8);
      EXPECT_NE(other.dark, symbol->dark);
      EXPECT_EQ(withMask(other, symbol->mask).dark, symbol->dark) << version << errorCorrectionName(level);
    }
  }
}

TEST(SymbolMask, LeavesTheCodewordsAsTheyAre) {
  const Symbol symbol = symbolOf({.version = 5});
  const CodewordLayout layout = layoutCodewords(symbol);
  for (int mask = 0; mask < 8; ++mask) {
    const Symbol masked = withMask(symbol, mask);
    EXPECT_EQ(masked.mask, mask);
    EXPECT_EQ(readBlocks(masked, layout), readBlocks(symbol, layout)) << mask;
  }
}

TEST(SymbolMask, RefusesAnUnknownMask) {
  const auto symbol = encodeSymbol("a", {.maskRule = MaskRule::Fixed, .mask = 8});
  ASSERT_FALSE(symbol);
  EXPECT_EQ(symbol.error().kind, ErrorKind::BadUsage);
}

TEST(ShadiestMask, SeesNoMoreSkyThanAnyOther) {
  const Symbol shadiest = symbolOf({.maskRule = MaskRule::Shadiest});
  const double least = SkyFraction(shadiest).mean(shadiest);
  for (int mask = 0; mask < 8; ++mask) {
    const Symbol other = symbolOf({.maskRule = MaskRule::Fixed, .mask = mask});
    EXPECT_LE(least, SkyFraction(other).mean(other)) << mask;
  }
}

TEST(SkyFraction, OfALoneModuleMatchesASquarePit) {
  // In the middle of the floor of a square pit of edge 1 and depth 1/2, the opening is the top of a cube's upper half,
  // seen from the cube's middle plane. The form factor of a square of edge a at distance a/2 on its axis is 4 corners
  // of (1/2π)(x/√(1+x²) atan(y/√(1+x²)) + y/√(1+y²) atan(x/√(1+y²))) with x = y = 1.
  const double corner = (std::atan(1 / std::sqrt(2.0)) / std::sqrt(2.0)) * 2 / (2 * 3.14159265358979);
  EXPECT_NEAR(SkyFraction::ofModuleAlone(), 4 * corner, 0.001);  // 32 directions
}

TEST(SkyFraction, IsOneForLightModulesAndMoreInTheMiddleOfADarkArea) {
  Symbol symbol = lightSymbol(9);
  for (int row = 2; row < 7; ++row)
    for (int column = 2; column < 7; ++column) symbol.dark.at(row, column) = 1;
  const SkyFraction sky(symbol);
  EXPECT_EQ(sky.of(0, 0), 1);
  EXPECT_GT(sky.of(4, 4), sky.of(2, 4));
  EXPECT_GT(sky.of(2, 4), sky.of(2, 2));
  EXPECT_GT(sky.of(2, 2), SkyFraction::ofModuleAlone());
}

TEST(SkyFraction, UpdatesToTheSameValuesAsAnew) {
  Symbol symbol = symbolOf({});
  SkyFraction sky(symbol);
  for (const int row : {9, 12, 15}) {
    symbol.dark.at(row, 12) = 0;
    sky.update(symbol, row, 12);
  }
  const SkyFraction anew(symbol);
  for (int row = 0; row < symbol.size; ++row)
    for (int column = 0; column < symbol.size; ++column) ASSERT_EQ(sky.of(row, column), anew.of(row, column));
}

TEST(RaisedErrorCorrection, IsTheHighestLevelThatTheVersionHolds) {
  for (const std::size_t length : {5u, 15u, 27u, 40u, 43u}) {
    const std::string text(length, 'x');
    const Result<Symbol> plain = encodeSymbol(text, {.errorCorrection = ErrorCorrection::L});
    const Result<Symbol> raised =
        encodeSymbol(text, {.errorCorrection = ErrorCorrection::L, .raiseErrorCorrection = true});
    ASSERT_TRUE(plain && raised);
    EXPECT_EQ(raised->version, plain->version);
    for (const ErrorCorrection level : kLevels) {
      const auto held = encodeSymbol(text, {.errorCorrection = level, .version = plain->version});
      EXPECT_EQ(held.has_value(), level <= raised->errorCorrection) << length << errorCorrectionName(level);
    }
  }
}

}  // namespace
}  // namespace qrelief
