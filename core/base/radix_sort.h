// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace qrelief {

/// A sort key and the index that goes with it.
struct KeyedIndex {
  std::uint64_t key;
  std::uint32_t index;
};

/// Sorts by key; equal keys keep their order. Goes from the least significant byte upwards and skips bytes that are the
/// same in all keys. Cost: O(n) for each byte that differs.
inline void radixSort(std::vector<KeyedIndex>& items) {
  std::array<std::array<std::size_t, 256>, 8> counts{};
  for (const KeyedIndex& item : items)
    for (std::size_t byte = 0; byte < 8; ++byte) ++counts[byte][item.key >> 8 * byte & 255];
  std::vector<KeyedIndex> sorted(items.size());
  for (std::size_t byte = 0; byte < 8; ++byte) {
    std::size_t begin = 0;
    bool allSame = false;
    for (std::size_t& count : counts[byte]) {
      allSame = allSame || count == items.size();
      begin += std::exchange(count, begin);
    }
    if (allSame) continue;
    for (const KeyedIndex& item : items) sorted[counts[byte][item.key >> 8 * byte & 255]++] = item;
    items.swap(sorted);
  }
}

}  // namespace qrelief
