// SPDX-License-Identifier: GPL-3.0-or-later
#include "label/ring_coverage.h"

#include <algorithm>
#include <cmath>

namespace qrelief {
namespace {

constexpr int kLines = 4;  // per row of pixels

/// Adds a stretch of a line to the pixels that it covers.
void addStretch(std::span<float> row, double from, double to) {
  from = std::clamp(from, 0.0, static_cast<double>(row.size()));
  to = std::clamp(to, 0.0, static_cast<double>(row.size()));
  for (auto pixel = static_cast<std::size_t>(from); static_cast<double>(pixel) < to; ++pixel) {
    const auto left = static_cast<double>(pixel);
    row[pixel] += static_cast<float>(std::min(to, left + 1) - std::max(from, left));
  }
}

}  // namespace

std::vector<std::uint8_t> ringCoverage(std::span<const Ring> rings, int pixels, double edge) {
  // Where each line crosses edges, in pixels from the left.
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(kLines) * static_cast<std::size_t>(pixels));
  const double scale = pixels / edge;
  const auto inPicture = [&](Vec2 corner) {
    return Vec2(corner.x * scale + pixels / 2.0, (pixels / 2.0 - corner.y * scale) * kLines - 0.5);
  };
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Vec2 from = inPicture(ring[i]), to = inPicture(ring[(i + 1) % ring.size()]);
      if (from.y > to.y) std::swap(from, to);
      const double last = std::min(std::ceil(to.y), static_cast<double>(crossings.size()));  // edges are half-open
      for (double line = std::max(0.0, std::ceil(from.y)); line < last; ++line)
        crossings[static_cast<std::size_t>(line)].push_back(from.x +
                                                            (line - from.y) / (to.y - from.y) * (to.x - from.x));
    }
  const auto size = static_cast<std::size_t>(pixels);
  std::vector<std::uint8_t> coverage(size * size);
  std::vector<float> row(size);
  for (std::size_t y = 0; y < size; ++y) {
    std::fill(row.begin(), row.end(), 0.0f);
    for (std::size_t line = kLines * y; line < kLines * (y + 1); ++line) {
      std::vector<double>& ends = crossings[line];
      std::sort(ends.begin(), ends.end());
      for (std::size_t i = 0; i + 1 < ends.size(); i += 2) addStretch(row, ends[i], ends[i + 1]);
    }
    for (std::size_t x = 0; x < size; ++x)
      coverage[y * size + x] = static_cast<std::uint8_t>(std::lround(std::min(1.0f, row[x] / kLines) * 255));
  }
  return coverage;
}

}  // namespace qrelief
