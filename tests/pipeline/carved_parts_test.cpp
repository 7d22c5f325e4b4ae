// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/carved_parts.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace qrelief {
namespace {

TEST(CarvedParts, KeptFacetsStayInTheirPartAndNewOnesJoinTheCarvedPart) {
  const Mesh box = shapes::box({2, 2, 2});
  const Mesh before = shapes::together(box, shapes::translated(box, {10, 0, 0}));
  std::vector<std::uint32_t> partOf(12, 0);
  partOf.resize(24, 1);
  // Carving would leave this: vertices renumbered, facets 3, 4 and 20 gone, two new ones at the end.
  Mesh after = before;
  after.positions.insert(after.positions.begin(), Vec3f(99, 0, 0));
  for (Triangle& triangle : after.triangles)
    for (std::uint32_t& v : triangle) ++v;
  for (const int gone : {20, 4, 3}) after.triangles.erase(after.triangles.begin() + gone);
  after.triangles.push_back({0, 1, 2});
  after.triangles.push_back({0, 2, 3});

  std::vector<std::uint32_t> expected(10, 0);
  expected.resize(21, 1);
  expected.resize(23, 0);
  EXPECT_EQ(partsAfterCarving(before, partOf, after, 21, 0), expected);
}

TEST(CarvedParts, IsEmptyForASinglePart) {
  const Mesh box = shapes::box({2, 2, 2});
  EXPECT_TRUE(partsAfterCarving(box, {}, box, 12, 0).empty());
}

}  // namespace
}  // namespace qrelief
