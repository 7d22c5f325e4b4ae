// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "light/directional_light.h"
#include "math/frame.h"
#include "render/surface_raster.h"

namespace qrelief {

/// Width of the part of the quiet zone that counts, in modules. A shadow there hides the symbol's border.
inline constexpr int kLitRingModules = 2;

/// Measures how unevenly sky and lamps light the uncarved surface under a code. Compares each module with the brightest
/// module up to four away, and returns the 98th percentile of the missing fraction of light, 0 (even) … 1.
///
/// Decoders compare a module with its neighbourhood. Where folds and ridges of the model cast shadows, or a lamp
/// grazes a curved surface, deeper pockets do not help.
///
/// Cost: O(triangles).
/// @param raster, box  of the model
/// @param lamps  in addition to the sky
/// @param ring  width of the part of the quiet zone that counts, in modules, ≥ 0
double unevenLight(const SurfaceRaster& raster, const Box3& box, const ProjectionFrame& frame, double symbolMm,
                   int modules, std::span<const DirectionalLight> lamps, int ring = kLitRingModules);

/// Greatest unevenLight() that counts as even. Of 67 spots up to this value, 66 decode as designed and as printed; of
/// 14 spots beyond it, 6 do (docs/decisions/0041).
inline constexpr double kMostUnevenLight = 0.055;

/// Looks for a place of a lamp from which it lights the surface evenly: in 45° steps round the code, at the lamp's own
/// elevation, 45° and 60°.
/// @param lamp  its strength is kept; the other parameters are as for unevenLight()
/// @returns the lamp with the least unevenLight(); none if that is greater than kMostUnevenLight
/// Cost: of unevenLight() for every place.
std::optional<DirectionalLight> evenLamp(const SurfaceRaster& raster, const Box3& box, const ProjectionFrame& frame,
                                         double symbolMm, int modules, const DirectionalLight& lamp, int ring);

}  // namespace qrelief
