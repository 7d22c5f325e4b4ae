// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/radix_sort.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "base/random.h"

namespace qrelief {
namespace {

TEST(RadixSort, SortsAsStdStableSortDoes) {
  Random random(5);
  for (const std::uint64_t range : {std::uint64_t{3}, std::uint64_t{1} << 20, ~std::uint64_t{0}}) {
    std::vector<KeyedIndex> items(5000);
    for (std::uint32_t i = 0; i < items.size(); ++i) items[i] = {random.below(range), i};
    std::vector<KeyedIndex> expected = items;
    std::stable_sort(expected.begin(), expected.end(),
                     [](const KeyedIndex& a, const KeyedIndex& b) { return a.key < b.key; });
    radixSort(items);
    for (std::size_t i = 0; i < items.size(); ++i) {
      ASSERT_EQ(items[i].key, expected[i].key);
      ASSERT_EQ(items[i].index, expected[i].index);
    }
  }
}

TEST(RadixSort, AcceptsAnEmptyList) {
  std::vector<KeyedIndex> items;
  radixSort(items);
  EXPECT_TRUE(items.empty());
}

}  // namespace
}  // namespace qrelief
