// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "math/vec.h"

namespace qrelief {

/// Resamples a square picture to a coarser grid of sensor cells, as means over their areas. Border pixels continue
/// outwards.
/// @param picture  width² values
/// @param step     pixels along a cell's edge, ≥ 1
/// @param phase    where the grid begins, in cells: 0 … 1
/// @returns as many whole cells as fit, row-major
std::vector<float> resampled(const std::vector<float>& picture, int width, double step, Vec2 phase = Vec2(0));

/// Resamples to a grid of any position and size.
/// @param step   pixels along a cell's edge, > 0
/// @param first  where the grid begins, in pixels
/// @param cells  along the edge
std::vector<float> areaMeans(const std::vector<float>& picture, int width, double step, Vec2 first, int cells);

/// Returns the edge of the picture that resampled() gives.
int resampledWidth(int width, double step);

}  // namespace qrelief
