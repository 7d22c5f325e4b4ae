// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/distance_transform.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "base/random.h"

namespace qrelief {
namespace {

std::vector<std::int32_t> byBruteForce(const std::vector<std::uint8_t>& blocked, int texels) {
  std::vector<std::int32_t> squared(blocked.size(), 2 * texels * texels);
  for (int i = 0; i < texels * texels; ++i) {
    for (int j = 0; j < texels * texels; ++j) {
      if (blocked[static_cast<std::size_t>(j)] == 0) continue;
      const int dx = i % texels - j % texels, dy = i / texels - j / texels;
      auto& least = squared[static_cast<std::size_t>(i)];
      least = std::min(least, dx * dx + dy * dy);
    }
  }
  return squared;
}

TEST(DistanceTransform, IsExactOnRandomMapsOfEverySparsity) {
  Random random(7);
  for (const int texels : {1, 2, 3, 17, 40}) {
    for (const std::uint64_t sparsity : {2u, 10u, 300u}) {
      std::vector<std::uint8_t> blocked(static_cast<std::size_t>(texels * texels), 0);
      for (std::uint8_t& b : blocked) b = random.below(sparsity) == 0 ? 1 : 0;
      blocked[static_cast<std::size_t>(random.below(blocked.size()))] = 1;
      EXPECT_EQ(squaredDistances(blocked, texels), byBruteForce(blocked, texels)) << texels << ", 1/" << sparsity;
    }
  }
}

TEST(DistanceTransform, MeasuresFromASingleCornerToTheOppositeOne) {
  std::vector<std::uint8_t> blocked(512 * 512, 0);
  blocked[0] = 1;
  EXPECT_EQ(squaredDistances(blocked, 512).back(), 2 * 511 * 511);
}

}  // namespace
}  // namespace qrelief
