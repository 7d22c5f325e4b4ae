// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_stl.h"

#include <cstring>
#include <gtest/gtest.h>
#include <string>

#include "io/read_stl.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

TEST(WriteStl, WritesPositionsBitForBit) {
  const Mesh mesh = shapes::bumpySphere(50, 3, 4, 2);
  const auto soup = readStl(writeStl(mesh), {});
  ASSERT_TRUE(soup);
  ASSERT_EQ(soup->triangles.size(), mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(Vec3f(soup->positions[3 * t + k]), mesh.positions[mesh.triangles[t][k]]);
}

TEST(WriteStl, HasTheSizeThatTheFormatRequires) {
  EXPECT_EQ(writeStl(shapes::box({1, 2, 3})).size(), 84u + 50u * 12u);
  EXPECT_EQ(writeStl(Mesh{}).size(), 84u);
}

TEST(WriteStl, WritesTheTitleIntoTheHeaderCutTo80Bytes) {
  const auto bytes = writeStl(shapes::box({1, 1, 1}), std::string(100, 'x'));
  EXPECT_EQ(bytes[79], 'x');
  EXPECT_EQ(bytes[80], 12);  // the count follows
}

TEST(WriteStl, NeverStartsWithSolid) {
  const auto bytes = writeStl(shapes::box({1, 1, 1}), "solid gold");
  EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + 17), "binary solid gold");
}

TEST(WriteStl, WritesUnitNormalsThatPointOutwards) {
  const Mesh mesh = shapes::box({2, 2, 2});
  const auto bytes = writeStl(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Vec3f normal;
    std::memcpy(&normal, bytes.data() + 84 + 50 * t, sizeof(normal));
    const Vec3 centre = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
    EXPECT_NEAR(glm::dot(Vec3(normal), centre), 1, 1e-12);
  }
}

}  // namespace
}  // namespace qrelief
