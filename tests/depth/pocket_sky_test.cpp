// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth/pocket_sky.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>

#include "support/instruction_sets.h"

namespace qrelief {
namespace {

SubmoduleMask maskOf(int size, const std::function<bool(int, int)>& isCarved) {
  SubmoduleMask mask(size, size);
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) mask.at(row, column) = isCarved(row, column);
  return mask;
}

TEST(PocketSky, MatchesTheFormFactorOfASquarePit) {
  // Form factor of two parallel squares of edge 1 at a distance of 1/2, with x = 1/(1/2): floor and opening.
  const double x = 2, root = std::sqrt(1 + x * x);
  const double factor =
      2 / (std::numbers::pi * x * x) *
      (std::log(root * root / std::sqrt(1 + 2 * x * x)) + 2 * x * root * std::atan(x / root) - 2 * x * std::atan(x));
  const PocketSky sky(maskOf(5, [](int row, int column) { return row == 2 && column == 2; }), 1);
  EXPECT_NEAR(PocketSky::Depths(sky, std::vector<double>{0.5}).fraction(0, 0.5), factor, 0.005);
}

TEST(PocketSky, MatchesTheClosedFormOfALongTrench) {
  // Floor of an infinite trench of width w and depth h: √(1 + (h/w)²) − h/w.
  const PocketSky sky(maskOf(101, [](int, int column) { return column == 50; }), 0.4);
  const std::vector<double> depths(101, 0.3);
  EXPECT_NEAR(PocketSky::Depths(sky, depths).fraction(50, 0.3), std::hypot(1, 0.75) - 0.75, 0.01);
}

TEST(PocketSky, IsTheSameForAllInstructionSets) {
  const PocketSky sky(maskOf(30, [](int row, int column) { return (row / 5 * 7 + column / 5 * 3) % 4 != 0; }), 0.2);
  const std::size_t floors = sky.carved().size();
  expectSameByAllInstructionSets([&] {
    std::vector<double> depths(floors, 0.1);
    const std::vector<double> fractions(floors, 0.6), limits(floors, 1.5);
    sky.solve(fractions, limits, depths, std::vector<char>(floors, 1), 20);
    return depths;
  });
}

TEST(PocketSky, StepsBetweenFloorsCountByTheirHeight) {
  const PocketSky sky(maskOf(9, [](int, int) { return true; }), 1);
  std::vector<double> depths(81, 0.0);
  EXPECT_EQ(PocketSky::Depths(sky, depths).fraction(40, 0), 1);
  const double alone = PocketSky::Depths(sky, depths).fraction(40, 0.5);
  EXPECT_LT(alone, 0.6);
  for (double& depth : depths) depth = 0.5;
  EXPECT_GT(PocketSky::Depths(sky, depths).fraction(40, 0.5),
            0.98);  // only the symbol's rim shades it, four and a half submodules away
}

class PocketSkySolve : public testing::Test {
 protected:
  PocketSkySolve()
      : sky_(maskOf(20, [](int row, int column) { return (row / 5 + column / 5) % 2 == 0 || row < 5; }), 0.2),
        limits_(sky_.carved().size(), 2) {
    for (std::size_t k = 0; k < limits_.size(); ++k) shares_.push_back(0.4 + 0.03 * static_cast<double>(k % 8));
  }
  std::vector<double> solvedFrom(double startMm) const {
    std::vector<double> depths(limits_.size(), startMm);
    sky_.solve(shares_, limits_, depths, std::vector<char>(shares_.size(), 1), 1000);
    return depths;
  }
  PocketSky sky_;
  std::vector<double> limits_, shares_;
};

TEST_F(PocketSkySolve, EveryFloorSeesExactlyItsShareOfTheSky) {
  const std::vector<double> depths = solvedFrom(0.2);
  const PocketSky::Depths solved(sky_, depths);
  for (std::size_t k = 0; k < depths.size(); ++k) {
    ASSERT_LT(depths[k], 2);
    EXPECT_LE(solved.fraction(k, depths[k] + 0.003), shares_[k]) << k;
    EXPECT_GE(solved.fraction(k, depths[k] - 0.003), shares_[k]) << k;
  }
}

TEST_F(PocketSkySolve, FindsTheSameDepthsFromAnyStart) {
  const std::vector<double> fromBelow = solvedFrom(0.001), fromAbove = solvedFrom(1.9);
  for (std::size_t k = 0; k < fromBelow.size(); ++k) EXPECT_NEAR(fromBelow[k], fromAbove[k], 0.02) << k;
}

TEST_F(PocketSkySolve, StopsAtTheLimits) {
  limits_.assign(limits_.size(), 0.05);
  limits_[3] = 0;
  const std::vector<double> depths = solvedFrom(0.02);
  for (std::size_t k = 0; k < depths.size(); ++k) EXPECT_LE(depths[k], limits_[k]);
  EXPECT_EQ(depths[3], 0);
}

}  // namespace
}  // namespace qrelief
