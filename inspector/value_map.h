// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "math/vec.h"

namespace qrelief {

/// A picture of numbers over symbol and quiet zone, as the reader sees it: row 0 at the top.
struct ValueMap {
  static constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

  int columns = 0, rows = 0;
  std::vector<float> values;  ///< row-major; kNothing where there is no value
  std::vector<Vec3f>
      directions;  ///< unit vectors (right, up, to the reader) that the values are angles of; may be empty

  /// Index of the value at a place, (0, 0) = upper left, (1, 1) = lower right; none outside.
  std::optional<std::size_t> indexAt(Vec2 place) const;
};

struct ValueRange {
  float lowest = 0, highest = 1;
  bool operator==(const ValueRange&) const = default;
};

/// The range of what is a number, without this share of it at either end; none if nothing is.
/// @param cutShare  0 … 0.5: a few far outliers need not take all colours
std::optional<ValueRange> rangeOf(std::span<const float> values, double cutShare = 0);

/// How many values fall into each of equal parts of a range; what lies beyond counts to the nearest part, what is not a
/// number to none.
std::vector<int> histogramOf(std::span<const float> values, ValueRange range, int parts);

}  // namespace qrelief
