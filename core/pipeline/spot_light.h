// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "math/frame.h"
#include "render/surface_raster.h"

namespace qrelief {

/// Width of the part of the quiet zone that counts, in modules. A shadow there hides the symbol's border.
inline constexpr int kLitRingModules = 2;

/// Measures how unevenly the sky lights the uncarved surface under a code. Compares each module with the brightest
/// module up to four away, and returns the 98th percentile of the missing fraction of light, 0 (even) … 1.
///
/// Decoders compare a module with its neighbourhood. Where folds and ridges of the model cast shadows, deeper pockets
/// do not help.
///
/// Cost: O(triangles).
/// @param raster, box  of the model
/// @param ring  width of the part of the quiet zone that counts, in modules, ≥ 0
double unevenLight(const SurfaceRaster& raster, const Box3& box, const ProjectionFrame& frame, double symbolMm,
                   int modules, int ring = kLitRingModules);

/// Greatest unevenLight() that counts as even. Of 67 spots up to this value, 66 decode as designed and as printed; of
/// 14 spots beyond it, 6 do (docs/decisions/0041).
inline constexpr double kMostUnevenLight = 0.055;

}  // namespace qrelief
