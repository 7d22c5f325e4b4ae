// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/resample.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace qrelief {
namespace {

/// Averages the rows of `picture` over cells and writes them as columns, so that two passes resample both directions.
/// @param first  pixel where the cells begin
std::vector<float> alongRows(const std::vector<float>& picture, int width, int height, double step, double first,
                             int cells) {
  std::vector<float> out(static_cast<std::size_t>(cells) * static_cast<std::size_t>(height));
  for (int c = 0; c < cells; ++c) {
    const double begin = first + c * step, end = begin + step;
    for (int row = 0; row < height; ++row) {
      double sum = 0;
      for (int x = static_cast<int>(std::floor(begin)); x < end; ++x) {
        const double fraction = std::min(end, x + 1.0) - std::max<double>(begin, x);
        sum += fraction * static_cast<double>(picture[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                                      static_cast<std::size_t>(std::clamp(x, 0, width - 1))]);
      }
      out[static_cast<std::size_t>(c) * static_cast<std::size_t>(height) + static_cast<std::size_t>(row)] =
          static_cast<float>(sum / step);
    }
  }
  return out;
}

}  // namespace

int resampledWidth(int width, double step) { return std::max(1, static_cast<int>(std::floor(width / step + 1e-9))); }

std::vector<float> areaMeans(const std::vector<float>& picture, int width, double step, Vec2 first, int cells) {
  assert(step > 0 && picture.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(width));
  const std::vector<float> turned = alongRows(picture, width, width, step, first.x, cells);
  return alongRows(turned, width, cells, step, first.y, cells);
}

std::vector<float> resampled(const std::vector<float>& picture, int width, double step, Vec2 phase) {
  assert(step >= 1);
  return areaMeans(picture, width, step, phase * step, resampledWidth(width, step));
}

}  // namespace qrelief
