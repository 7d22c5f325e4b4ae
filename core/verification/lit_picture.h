// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "light/height_map.h"

namespace qrelief {

/// A square picture of a lit height map from the reader's eye, centred on it.
struct PictureGrid {
  double pixelMm = 0.1;  ///< on the QR plane, > 0
  int pixels = 400;      ///< along the edge
};

/// Luminance of the pixels, means over their areas, 1 = an unoccluded surface; row 0 at the bottom.
/// @param luminance  of every patch
/// @param missing    luminance where there is no surface
std::vector<float> litPicture(const HeightMap& map, std::vector<float> luminance, const PictureGrid& grid,
                              float missing);

}  // namespace qrelief
