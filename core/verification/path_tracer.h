// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "light/directional_light.h"
#include "math/frame.h"
#include "mesh/ray_surface.h"

namespace qrelief {

/// A rectangle of the QR plane, mm, as a reader at the frame's eye sees it on the surface.
struct SeenCell {
  Vec2 min, max;
};

struct PathTraceOptions {
  int paths = 256;                            ///< per cell, ≥ 8; rounded down to a multiple of 8
  double albedo = 0.7;                        ///< of the matte material, 0 … 1
  std::uint64_t seed = 1;                     ///< the same seed, the same result
  std::vector<DirectionalLight> lights = {};  ///< at most kMaxLights
};

/// A mean over a cell and its standard error, from the spread of 8 independent estimates.
struct Traced {
  double mean = 0, standardError = 0;
};

/// What reaches a cell.
struct CellLight {
  Traced visibility;  ///< fraction of a uniform sky that is seen, cosine-weighted
  Traced direct;      ///< irradiance by the lamps without bounces, 1 = by the whole sky
  Traced luminance;   ///< of sky and lamps with all bounces; 1 = an unoccluded surface in the QR plane
};

/// The yardstick for LuminancePass: what light sky and lamps bring to the surface, by path tracing the mesh itself,
/// with every bounce and the lamps asked at each (traceLight).
/// Independent of the maps: it knows the mesh, the eye and nothing else.
///
/// Each path starts at a point of the cell (Halton points, shifted at random per estimate), goes from the eye to the
/// surface and on in a cosine-weighted direction. Cells whose ray misses the mesh are open.
/// Cost: O(cells · paths · log T), on all cores; the result does not depend on their number.
std::vector<CellLight> traceCells(const RaySurface& surface, const ProjectionFrame& frame,
                                  std::span<const SeenCell> cells, const PathTraceOptions& options);

}  // namespace qrelief
