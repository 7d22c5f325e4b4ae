// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/grid.h"
#include "light/height_map.h"

namespace qrelief {

/// Grid of a square picture of a lit height map, seen from the eye and centred on the map.
struct PictureGrid {
  double pixelMm = 0.1;  ///< on the QR plane, > 0
  int pixels = 400;      ///< along the edge
};

/// Returns the luminance of the pixels, averaged over their areas. 1 = an unoccluded surface.
/// @param luminance  of every patch
/// @param missing    luminance where there is no surface
BottomUp<float> litPicture(const HeightMap& map, std::vector<float> luminance, const PictureGrid& grid, float missing);

}  // namespace qrelief
