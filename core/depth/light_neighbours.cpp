// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth/light_neighbours.h"

#include <algorithm>
#include <cstdlib>

namespace qrelief {
namespace {

constexpr std::size_t kDarkest = 4;

}  // namespace

LightNeighbours::LightNeighbours(const Symbol& symbol, Surroundings surroundings) {
  const int m = symbol.size;
  const int withQuiet = m + 2 * kQuietZoneModules;
  const auto counts = [&](int row, int column) {
    return surroundings == Surroundings::EightNeighbours || row < 0 || column < 0 || row >= m || column >= m ||
           !symbol.isDark(row, column);
  };
  around_.resize(static_cast<std::size_t>(m * m));
  for (int row = 0; row < m; ++row) {
    for (int column = 0; column < m; ++column) {
      if (!symbol.isDark(row, column)) continue;
      auto& neighbours = around_[row * m + column];
      for (int ring = 1; neighbours.size() < kDarkest && ring < withQuiet; ++ring) {
        for (int r = row - ring; r <= row + ring; ++r) {
          for (int c = column - ring; c <= column + ring; ++c) {
            if (std::max(std::abs(r - row), std::abs(c - column)) != ring) continue;
            const int quietRow = r + kQuietZoneModules, quietColumn = c + kQuietZoneModules;
            if (quietRow < 0 || quietColumn < 0 || quietRow >= withQuiet || quietColumn >= withQuiet) continue;
            if (counts(r, c)) neighbours.push_back(static_cast<std::uint32_t>(quietRow * withQuiet + quietColumn));
          }
        }
      }
    }
  }
}

double LightNeighbours::darkestMean(std::size_t module, const Grid<double>& luminance) const {
  std::vector<double> around;
  for (const std::uint32_t light : around_[module]) around.push_back(luminance[light]);
  const std::size_t count = std::min(kDarkest, around.size());
  std::partial_sort(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(count), around.end());
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += around[i];
  return sum / static_cast<double>(count);
}

}  // namespace qrelief
