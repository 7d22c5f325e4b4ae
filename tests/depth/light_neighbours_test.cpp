// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth/light_neighbours.h"

#include <gtest/gtest.h>

#include "support/symbols.h"

namespace qrelief {
namespace {

constexpr int kSize = 21;
constexpr int kWithQuiet = kSize + 2 * kQuietZoneModules;

class LightNeighboursTest : public testing::Test {
 protected:
  static std::size_t moduleAt(int row, int column) { return static_cast<std::size_t>(row * kSize + column); }
  double& luminanceAt(int row, int column) {
    return luminance_.at(row + kQuietZoneModules, column + kQuietZoneModules);
  }
  Symbol symbol_ = lightSymbol(kSize);
  Grid<double> luminance_{kWithQuiet, kWithQuiet, 1};
};

TEST_F(LightNeighboursTest, TakesTheFourDarkestOfTheEightNeighbours) {
  symbol_.dark[moduleAt(10, 10)] = 1;
  luminanceAt(9, 9) = 0.5;
  luminanceAt(9, 10) = 0.6;
  luminanceAt(11, 11) = 0.7;
  luminanceAt(10, 11) = 0.8;
  luminanceAt(10, 9) = 0.9;
  luminanceAt(10, 10) = 0;    // itself
  luminanceAt(10, 12) = 0.1;  // too far
  EXPECT_DOUBLE_EQ(LightNeighbours(symbol_).darkestMean(moduleAt(10, 10), luminance_), 0.65);
}

TEST_F(LightNeighboursTest, SkipsDarkNeighboursAndLooksFartherForFour) {
  for (int row = 9; row <= 11; ++row)
    for (int column = 9; column <= 11; ++column) {
      symbol_.dark[moduleAt(row, column)] = 1;
      luminanceAt(row, column) = 0;
    }
  symbol_.dark[moduleAt(9, 9)] = 0;  // one light neighbour is left, so the ring of 16 beyond joins in
  luminanceAt(9, 9) = 0.2;
  luminanceAt(8, 8) = 0.6;
  EXPECT_DOUBLE_EQ(LightNeighbours(symbol_).darkestMean(moduleAt(10, 10), luminance_), (0.2 + 0.6 + 1 + 1) / 4);
}

TEST_F(LightNeighboursTest, TakenLiterallyDarkNeighboursCountAndNothingFarther) {
  for (int row = 9; row <= 11; ++row)
    for (int column = 9; column <= 11; ++column) {
      symbol_.dark[moduleAt(row, column)] = 1;
      luminanceAt(row, column) = 0.5;
    }
  luminanceAt(9, 9) = 0.1;
  luminanceAt(10, 10) = 0;  // itself
  luminanceAt(8, 8) = 0.2;  // two modules away
  const LightNeighbours literal(symbol_, Surroundings::EightNeighbours);
  EXPECT_DOUBLE_EQ(literal.darkestMean(moduleAt(10, 10), luminance_), (0.1 + 3 * 0.5) / 4);
}

TEST_F(LightNeighboursTest, TheQuietZoneIsLight) {
  symbol_.dark[moduleAt(0, 0)] = 1;
  luminanceAt(-1, -1) = luminanceAt(-1, 0) = luminanceAt(-1, 1) = luminanceAt(0, -1) = 0.4;
  EXPECT_DOUBLE_EQ(LightNeighbours(symbol_).darkestMean(moduleAt(0, 0), luminance_), 0.4);
}

}  // namespace
}  // namespace qrelief
