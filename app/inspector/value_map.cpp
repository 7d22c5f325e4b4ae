// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/value_map.h"

#include <algorithm>
#include <cmath>

namespace qrelief {

std::optional<std::size_t> ValueMap::indexAt(Vec2 place) const {
  if (!(place.x >= 0 && place.x < 1 && place.y >= 0 && place.y < 1) || values.empty()) return {};
  const auto column = static_cast<std::size_t>(place.x * columns), row = static_cast<std::size_t>(place.y * rows);
  return row * static_cast<std::size_t>(columns) + column;
}

std::optional<ValueRange> rangeOf(std::span<const float> values, double cutShare) {
  std::vector<float> numbers;
  for (const float value : values)
    if (std::isfinite(value)) numbers.push_back(value);
  if (numbers.empty()) return {};
  const auto cut = static_cast<std::ptrdiff_t>(cutShare * static_cast<double>(numbers.size() - 1));
  const auto at = [&](std::ptrdiff_t k) {
    std::nth_element(numbers.begin(), numbers.begin() + k, numbers.end());
    return numbers[k];
  };
  return ValueRange{at(cut), at(static_cast<std::ptrdiff_t>(numbers.size()) - 1 - cut)};
}

std::vector<int> histogramOf(std::span<const float> values, ValueRange range, int parts) {
  std::vector<int> counts(static_cast<std::size_t>(parts), 0);
  const float width = std::max(range.highest - range.lowest, 1e-12f);
  for (const float value : values) {
    if (!std::isfinite(value)) continue;
    const float part = (value - range.lowest) / width * static_cast<float>(parts);
    ++counts[static_cast<std::size_t>(std::clamp(part, 0.0f, static_cast<float>(parts - 1)))];
  }
  return counts;
}

}  // namespace qrelief
