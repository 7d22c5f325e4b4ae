// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/grid.h"
#include "light/height_map.h"
#include "math/vec.h"

namespace qrelief {

/// Resamples a square picture to a coarser grid of sensor cells, as means over their areas. Border pixels continue
/// outwards.
/// @param step     pixels along a cell's edge, ≥ 1
/// @param phase    where the grid begins, in cells: 0 … 1
/// @returns as many whole cells as fit
template <RowOrder kOrder>
Grid<float, kOrder> resampled(const Grid<float, kOrder>& picture, double step, Vec2 phase = Vec2(0));

/// Resamples to a grid of any position and size.
/// @param step   pixels along a cell's edge, > 0
/// @param first  where the grid begins, in pixels
/// @param cells  along the edge
template <RowOrder kOrder>
Grid<float, kOrder> areaMeans(const Grid<float, kOrder>& picture, double step, Vec2 first, int cells);

/// Grid of a square picture of a lit height map, seen from the eye and centred on the map.
struct PictureGrid {
  double pixelMm = 0.1;  ///< on the QR plane, > 0
  int pixels = 400;      ///< along the edge
};

/// Returns the luminance of the pixels, averaged over their areas. 1 = an unoccluded surface.
/// @param luminance  of every patch
/// @param missing    luminance of pixels without a surface
BottomUp<float> litPicture(const HeightMap& map, std::vector<float> luminance, const PictureGrid& grid, float missing);

}  // namespace qrelief
