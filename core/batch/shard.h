// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace qrelief {

/// The share of one process among several: every `count`-th item, starting at `index`.
struct Shard {
  std::size_t index = 0;  ///< < count
  std::size_t count = 1;

  bool has(std::size_t item) const { return item % count == index; }
  bool isWhole() const { return count == 1; }
  std::string name() const { return std::to_string(index) + "-of-" + std::to_string(count); }

  /// Parses a text such as "2/8".
  /// @returns none for anything else, or for an index that is not below the count
  static std::optional<Shard> parse(std::string_view text);
};

}  // namespace qrelief
