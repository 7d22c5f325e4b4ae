// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/grid.h"
#include "render/surface_raster.h"

namespace qrelief {

struct EngraveResult;

/// Multiplies a camera's picture of a code in colour by the reflectances of the materials in it.
/// Cost: as SurfaceRaster::draw().
/// @param luminance  square
/// @param extentMm   edge of the picture on the camera's QR plane
/// @param surface    of the model before engraving; a code in colour does not change the surface
void addInkSeen(BottomUp<float>& luminance, const ProjectionFrame& camera, double extentMm,
                const SurfaceRaster& surface, const EngraveResult& result);

}  // namespace qrelief
