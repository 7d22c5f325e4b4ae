// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "math/vec.h"

namespace qrelief {

/// A square picture as a coarser grid of sensor cells sees it: means over their areas. What lies beyond the border
/// counts as the border does.
/// @param picture  width² values
/// @param step     pixels along a cell's edge, ≥ 1
/// @param phase    where the grid begins, in cells: 0 … 1
/// @returns as many whole cells as fit, row-major
std::vector<float> resampled(const std::vector<float>& picture, int width, double step, Vec2 phase = Vec2(0));

/// The same for a grid of any cells.
/// @param step   pixels along a cell's edge, > 0
/// @param first  where the grid begins, in pixels
/// @param cells  along the edge
std::vector<float> areaMeans(const std::vector<float>& picture, int width, double step, Vec2 first, int cells);

/// Edge of the picture that resampled() gives.
int resampledWidth(int width, double step);

}  // namespace qrelief
