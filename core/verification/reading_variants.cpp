// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/reading_variants.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "verification/resample.h"

namespace qrelief {
namespace {

/// Stretches the contrast: the 1st percentile becomes black and the 99th white.
GreyImage stretched(GreyImage image) {
  std::array<std::size_t, 256> counts{};
  for (const std::uint8_t pixel : image.pixels) ++counts[pixel];
  const auto valueAt = [&](std::size_t place) {  // in the order of the sorted pixels
    std::size_t value = 0;
    for (std::size_t before = counts[0]; before <= place; before += counts[++value]) {
    }
    return static_cast<double>(value);
  };
  const double low = valueAt(image.pixels.size() / 100);
  const double high = valueAt(image.pixels.size() - 1 - image.pixels.size() / 100);
  std::array<std::uint8_t, 256> to{};
  for (std::size_t value = 0; value < to.size(); ++value)
    to[value] = static_cast<std::uint8_t>(
        std::lround(std::clamp((static_cast<double>(value) - low) * 255 / std::max(high - low, 1.0), 0.0, 255.0)));
  for (std::uint8_t& pixel : image.pixels) pixel = to[pixel];
  return image;
}

GreyImage shrunk(const GreyImage& image, int factor) {
  GreyImage small{image.width / factor, image.height / factor, {}};
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      int sum = 0;
      for (int k = 0; k < factor * factor; ++k)
        sum += image.pixels[(y * factor + k / factor) * image.width + x * factor + k % factor];
      small.pixels.push_back(static_cast<std::uint8_t>((sum + factor * factor / 2) / (factor * factor)));
    }
  }
  return small;
}

}  // namespace

std::vector<GreyImage> readingVariants(const GreyImage& picture, double pixelsPerModule) {
  const auto outOfFocus = [&](double modules) { return stretched(blurred(picture, modules * pixelsPerModule)); };
  return {picture,
          stretched(picture),
          outOfFocus(0.2),
          outOfFocus(0.35),
          stretched(shrunk(picture, 2)),
          stretched(shrunk(picture, 3))};
}

GreyImage fromFarther(const GreyImage& picture, double fraction) {
  if (fraction >= 1) return picture;
  const Grid<float> pixels(picture.height, picture.width, {picture.pixels.begin(), picture.pixels.end()});
  const Grid<float> cells = resampled(pixels, 1 / fraction);
  GreyImage far{cells.columns(), cells.rows(), {}};
  for (const float value : cells) far.pixels.push_back(static_cast<std::uint8_t>(std::lround(value)));
  return far;
}

}  // namespace qrelief
