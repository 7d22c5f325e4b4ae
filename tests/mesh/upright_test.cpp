// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/upright.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace qrelief {
namespace {

/// Returns a pyramid that stands on its square base, z up.
Mesh pyramid() {
  Mesh mesh;
  mesh.positions = {{-20, -20, 0}, {20, -20, 0}, {20, 20, 0}, {-20, 20, 0}, {0, 0, 50}};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  return mesh;
}

/// Turns a mesh whose z points up so that its y does.
Mesh yUp(Mesh mesh) {
  for (auto& p : mesh.positions) p = {p.x, p.z, -p.y};
  return mesh;
}

TEST(Upright, AModelOnAFlatBaseAtItsLowestYStandsOnY) {
  EXPECT_FALSE(standsOnY(pyramid()));
  EXPECT_TRUE(standsOnY(yUp(pyramid())));
}

TEST(Upright, AFlatBaseAtTheLowestZDecides) {
  EXPECT_FALSE(standsOnY(shapes::box({100, 5, 100}))) << "a board on its edge";
  EXPECT_FALSE(standsOnY(shapes::box({100, 100, 5})));
}

TEST(Upright, ARoundModelStandsOnNoAxis) { EXPECT_FALSE(standsOnY(shapes::icosphere(20, 3))); }

}  // namespace
}  // namespace qrelief
