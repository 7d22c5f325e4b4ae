// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "math/frame.h"
#include "mesh/mesh.h"
#include "projection/visible_patch.h"
#include "qr/module_pattern.h"

namespace qrelief {

struct WallLimitOptions {
  double symbolMm = 0;    ///< edge of the symbol without quiet zone, on the QR plane, > 0
  double maxDepthMm = 0;  ///< no submodule is carved deeper, along its ray, ≥ 0
  double minWallMm = 0;   ///< material that must remain behind and beside every floor, in any direction, ≥ 0
};

/// How deep each submodule may be carved at most so that a wall of `minWallMm` remains [Papp 2022, §7: thickness; here
/// in every direction, not only along the ray]: no point of its floor, at that depth or on the way there, comes nearer
/// than `minWallMm` to a facet that is not part of the visible patch. Such facets are the back of the body, its sides
/// beyond the silhouette and what the eye cannot see; front-facing ones outside the patch's radius, of which nothing is
/// known, do not count: choose that radius `minWallMm + maxDepthMm` larger than half the symbol's diagonal.
///
/// **Method.** The distance d(x) of a point from those facets changes by no more than the point moves. So one query at
/// the surface over the submodule's centre settles most: d − maxDepth − (distance of the corners) ≥ minWall. Else
/// centre and four corners walk down their rays together, each time by the least d − minWall (sphere tracing), but
/// by no less than half of kDepthQuantumMm, so that the walk goes on along walls it runs parallel to. So the limit is
/// too deep by no more than the floor bulges between those five points, and too shallow by no more than that half.
///
/// Cost: one pass over the mesh, a tree over the facets near the carved region, one query a submodule or, near a wall,
/// a few dozen.
/// @param carved          size × size submodules; row-major from the symbol's top left
/// @param baseDistanceMm  per submodule: distance from the eye to the surface along the ray through its centre;
///                        NaN = outside the silhouette. Corners are interpolated.
/// @returns per submodule the limit in mm along its ray, 0 … maxDepthMm; 0 where nothing is carved or there is no
///          surface
std::vector<double> wallLimits(const Mesh& mesh, const VisiblePatch& patch, const ProjectionFrame& frame,
                               const SubmoduleMask& carved, std::span<const float> baseDistanceMm,
                               const WallLimitOptions& options);

}  // namespace qrelief
