// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/affine.h"

#include <gtest/gtest.h>
#include <random>

namespace qrelief {
namespace {

TEST(Affine, TurnedUpIsTheLeastRotationToTheVertical) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<Vec3> ups = {{0, 0, 1}, {0, 0, -1}, {5, 0, 0}, {1e-7, 0, -1}};
  for (int i = 0; i < 200; ++i) ups.emplace_back(normal(random), normal(random), normal(random));
  for (const Vec3 up : ups) {
    const Affine turn = turnedUp(up);
    EXPECT_NEAR(glm::distance(turn(glm::normalize(up)), Vec3(0, 0, 1)), 0, 1e-9);
    EXPECT_NEAR(turn.determinant(), 1, 1e-9);
    EXPECT_NEAR(glm::dot(turn.x, turn.y), 0, 1e-9);
    EXPECT_NEAR(glm::length(turn.x), 1, 1e-9);
    // A rotation by the least angle leaves the axis, which is normal to both directions.
    const Vec3 axis = glm::cross(glm::normalize(up), Vec3(0, 0, 1));
    EXPECT_NEAR(glm::distance(turn(axis), axis), 0, 1e-9);
    EXPECT_NEAR(glm::distance(turn.inverse()(turn(up)), up), 0, 1e-9);
  }
  EXPECT_EQ(turnedUp({0, 0, 2}), Affine());
}

TEST(Affine, ComposesLikeMatrices) {
  const Affine a{{0, 2, 0}, {1, 0, 0}, {0, 0, 3}, {4, 5, 6}};
  const Affine b{{1, 1, 0}, {0, 1, 1}, {1, 0, 1}, {7, 8, 9}};
  for (const Vec3 p : {Vec3(1, 2, 3), Vec3(0), Vec3(-5, 0.5, 2)}) EXPECT_EQ(a.after(b)(p), a(b(p)));
  EXPECT_EQ(a.determinant(), -6);
  EXPECT_EQ(a.after(b).determinant(), a.determinant() * b.determinant());
}

}  // namespace
}  // namespace qrelief
