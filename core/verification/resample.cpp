// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/resample.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace qrelief {

namespace {

/// Averages the rows of `picture` over cells and writes them as columns, so that two passes resample both directions.
/// @param first  pixel where the cells begin
template <RowOrder kOrder>
Grid<float, kOrder> alongRows(const Grid<float, kOrder>& picture, double step, double first, int cells) {
  Grid<float, kOrder> out(cells, picture.rows());
  for (int c = 0; c < cells; ++c) {
    const double begin = first + c * step, end = begin + step;
    for (int row = 0; row < picture.rows(); ++row) {
      double sum = 0;
      for (int x = static_cast<int>(std::floor(begin)); x < end; ++x) {
        const double fraction = std::min(end, x + 1.0) - std::max<double>(begin, x);
        sum += fraction * static_cast<double>(picture.at(row, std::clamp(x, 0, picture.columns() - 1)));
      }
      out.at(c, row) = static_cast<float>(sum / step);
    }
  }
  return out;
}

}  // namespace

template <RowOrder kOrder>
Grid<float, kOrder> areaMeans(const Grid<float, kOrder>& picture, double step, Vec2 first, int cells) {
  assert(step > 0 && picture.rows() == picture.columns());
  return alongRows(alongRows(picture, step, first.x, cells), step, first.y, cells);
}

template <RowOrder kOrder>
Grid<float, kOrder> resampled(const Grid<float, kOrder>& picture, double step, Vec2 phase) {
  assert(step >= 1);
  const int cells = std::max(1, static_cast<int>(std::floor(picture.columns() / step + 1e-9)));
  return areaMeans(picture, step, phase * step, cells);
}

template BottomUp<float> areaMeans(const BottomUp<float>&, double, Vec2, int);
template BottomUp<float> resampled(const BottomUp<float>&, double, Vec2);
template Grid<float> resampled(const Grid<float>&, double, Vec2);

BottomUp<float> litPicture(const HeightMap& map, std::vector<float> luminance, const PictureGrid& grid, float missing) {
  for (std::size_t patch = 0; patch < luminance.size(); ++patch)
    if (!map.isSurface(patch)) luminance[patch] = missing;
  const double step = grid.pixelMm / map.patchMm;
  const double before = (map.size - grid.pixels * step) / 2;  // patches before the first pixel
  BottomUp<float> patches(map.size, map.size, std::move(luminance));
  if (grid.pixels == map.size && std::abs(before) < 1e-9) return patches;
  return areaMeans(patches, step, Vec2(before), grid.pixels);
}

}  // namespace qrelief
