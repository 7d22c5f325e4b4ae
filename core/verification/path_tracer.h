// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/frame.h"
#include "mesh/ray_tree.h"

namespace qrelief {

/// A rectangle of the QR plane, mm, as a reader at the frame's eye sees it on the surface.
struct SeenCell {
  Vec2 min, max;
};

struct PathTraceOptions {
  int paths = 256;         ///< per cell, ≥ 1
  double albedo = 0.7;     ///< of the matte material, 0 … 1
  std::uint64_t seed = 1;  ///< the same seed, the same result
};

/// What reaches a cell, means over it; 1 = an unoccluded plane.
struct CellLight {
  double visibility = 0;  ///< share of a uniform sky that is seen, cosine-weighted
  double luminance = 0;   ///< with all bounces
  double deviation = 0;   ///< standard error of `luminance`
};

/// The yardstick for LuminancePass: what light a uniform sky brings to the surface, by path tracing the mesh itself,
/// with every bounce (Russian roulette after the third, so without bias) [Kajiya 1986]. Independent of the maps: it
/// knows the mesh, the eye and nothing else.
///
/// Each path starts at a point of the cell (Halton points, shifted at random per cell), goes from the eye to the
/// surface and on in a cosine-weighted direction. Cells whose ray misses the mesh get 1.
/// Cost: O(cells · paths · log T).
std::vector<CellLight> traceCells(const RayTree& tree, const ProjectionFrame& frame, std::span<const SeenCell> cells,
                                  const PathTraceOptions& options);

}  // namespace qrelief
