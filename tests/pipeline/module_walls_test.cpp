// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/module_walls.h"

#include <gtest/gtest.h>

namespace qrelief {
namespace {

constexpr int kModules = 21;
constexpr CellSquare kSquare{42, kModules};  // cells of 2 mm
constexpr double kDepth = 0.5;               // modules: 1 mm at the full size

ModuleWalls wallsOf(double limitMm) {
  ModuleWalls walls;
  walls.limitMm.assign(kModules * kModules, limitMm);
  return walls;
}

double& limitAt(ModuleWalls& walls, int row, int column) {
  return walls.limitMm[static_cast<std::size_t>(row * kModules + column)];
}

TEST(ModuleWalls, APitMatchesItsClosedForm) {
  for (const double contrast : {0.1, 0.3, 0.6}) {
    const double depth = pitDepth(contrast), radius = 0.5;
    EXPECT_NEAR(radius * radius / (radius * radius + depth * depth), 1 - contrast, 1e-12);
  }
}

TEST(ModuleWalls, ThickWallsAllowTheWholeSize) {
  EXPECT_EQ(sizeThatWallsTake(wallsOf(1), kSquare, kModules, kDepth), 42);
}

TEST(ModuleWalls, WallsAllowExactlyTheirOwnDepth) {
  // The limit is computed as the caller does it, which may differ in the last bit.
  for (int i = 1; i < 100; ++i) {
    const CellSquare square{10 + 0.137 * i, kModules};
    const double moduleMm = square.edgeMm / kModules;
    EXPECT_EQ(sizeThatWallsTake(wallsOf(0.327 * moduleMm), square, kModules, 0.327), square.edgeMm);
  }
}

TEST(ModuleWalls, AnEvenlyThinWallReducesTheSizeInProportion) {
  const double size = sizeThatWallsTake(wallsOf(0.6), kSquare, kModules, kDepth);
  EXPECT_LE(size, 0.6 * 42);
  EXPECT_GT(size, 0.58 * 42);
}

TEST(ModuleWalls, NoModuleOfTheFinderPatternsMayBeThin) {
  for (const auto& [row, column] : {std::pair{0, 0}, std::pair{6, 20}, std::pair{20, 2}}) {
    ModuleWalls walls = wallsOf(1);
    limitAt(walls, row, column) = 0;
    EXPECT_LT(sizeThatWallsTake(walls, kSquare, kModules, kDepth), 42) << row << ", " << column;
  }
}

TEST(ModuleWalls, AFewOtherModulesMayBeThin) {
  ModuleWalls walls = wallsOf(1);
  for (int column = 8; column < 16; ++column) limitAt(walls, 19, column) = 0;  // 8 of 441, in the bottom rows
  EXPECT_EQ(sizeThatWallsTake(walls, kSquare, kModules, kDepth), 42);
  limitAt(walls, 19, 16) = 0;  // 9: more than 2 %
  EXPECT_LT(sizeThatWallsTake(walls, kSquare, kModules, kDepth), 42);
}

TEST(ModuleWalls, ReturnsNoSizeIfNoneHelps) { EXPECT_EQ(sizeThatWallsTake(wallsOf(0), kSquare, kModules, kDepth), 0); }

}  // namespace
}  // namespace qrelief
