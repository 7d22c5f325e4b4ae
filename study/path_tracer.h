// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "light/directional_light.h"
#include "math/frame.h"
#include "mesh/ray.h"

namespace qrelief::study {

/// A rectangle on the QR plane, mm, that the frame's eye sees projected onto the surface.
struct SeenCell {
  Vec2 min, max;
};

struct PathTraceOptions {
  int paths = 256;                            ///< per cell, ≥ 8; rounded down to a multiple of 8
  double albedo = 0.7;                        ///< reflectance of the matte material, 0 … 1
  std::uint64_t seed = 1;                     ///< the same seed gives the same result
  std::vector<DirectionalLight> lights = {};  ///< at most kMaxLights
};

/// A mean over a cell and its standard error, from the spread of 8 independent estimates.
struct Traced {
  double mean = 0, standardError = 0;
};

/// The light that reaches a cell.
struct CellLight {
  Traced visibility;  ///< visible fraction of a uniform sky, cosine-weighted
  Traced direct;      ///< irradiance by the lamps without bounces, 1 = irradiance by the whole sky
  Traced luminance;   ///< under sky and lamps with all bounces; 1 = an unoccluded surface in the QR plane
};

/// Computes the light that sky and lamps bring to the surface by path tracing the mesh itself. Follows every bounce and
/// samples the lamps at each (traceLight). This is the reference for LuminancePass. It is independent of the maps: it
/// uses only the mesh and the eye.
///
/// Each path starts at a point of the cell (Halton points, shifted at random per estimate), goes from the eye to the
/// surface and on in a cosine-weighted direction. Cells whose ray misses the mesh are open.
/// Cost: O(cells · paths · log T), on all cores; the result does not depend on the number of cores.
std::vector<CellLight> traceCells(const RaySurface& surface, const ProjectionFrame& frame,
                                  std::span<const SeenCell> cells, const PathTraceOptions& options);

}  // namespace qrelief::study
