// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/value_map.h"

#include <algorithm>
#include <array>
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

namespace {

constexpr int kShades = 1024;  // finer than a screen's

std::uint8_t byteOf(float component) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(0.5f + 0.5f * component, 0.0f, 1.0f)));
}

}  // namespace

std::vector<std::uint8_t> colouredRgba(const ValueMap& map, const MapColours& colours) {
  std::array<Rgb8, kShades> shades{};
  for (int i = 0; i < kShades; ++i) shades[i] = colourAt(colours.scale, static_cast<double>(i) / (kShades - 1));
  const bool directed = colours.showsDirections && !map.directions.empty();
  const float width = std::max(colours.range.highest - colours.range.lowest, 1e-12f);
  std::vector<std::uint8_t> rgba(4 * map.values.size(), 0);
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    const float value = map.values[i];
    if (!std::isfinite(value)) continue;
    const float share = std::clamp((value - colours.range.lowest) / width, 0.0f, 1.0f);
    Rgb8 colour = shades[static_cast<std::size_t>(std::lround(share * (kShades - 1)))];
    if (directed) colour = {byteOf(map.directions[i].x), byteOf(map.directions[i].y), byteOf(map.directions[i].z)};
    std::copy(colour.begin(), colour.end(), rgba.begin() + static_cast<std::ptrdiff_t>(4 * i));
    rgba[4 * i + 3] = 255;
  }
  return rgba;
}

gl::Texture mapPicture(const ValueMap& map, const MapColours& colours) {
  return {map.columns, map.rows, gl::Format::RGBA8, colouredRgba(map, colours).data()};
}

}  // namespace qrelief
