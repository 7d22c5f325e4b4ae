// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/lit_picture.h"

#include <cmath>

#include "verification/resample.h"

namespace qrelief {

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
