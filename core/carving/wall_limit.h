// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "math/frame.h"
#include "mesh/mesh.h"
#include "projection/silhouette.h"
#include "qr/module_pattern.h"

namespace qrelief {

struct WallLimitOptions {
  double symbolMm = 0;    ///< edge of the symbol without quiet zone, on the QR plane, > 0
  double maxDepthMm = 0;  ///< no submodule is carved deeper, along its ray, ≥ 0
  double minWallMm = 0;   ///< material that must remain behind and beside every floor, in any direction, ≥ 0
};

/// How deep each submodule may be carved at most so that a wall of `minWallMm` remains [Papp 2022, §7: thickness; here
/// in every direction, not only along the ray]: no point of its floor, at that depth or on the way there, comes nearer
/// than `minWallMm` to the other side of the material. The pocket's walls are what the floor's rim has swept on its way
/// down, so they keep the same distance. Other sides are
///
///   - facets that are not part of the visible patch: the back of the body, its sides beyond the silhouette, cavities,
///     other shells, whatever the eye cannot see. Front-facing ones outside the patch's radius, of which nothing is
///     known, do not count: choose that radius `minWallMm + maxDepthMm` larger than half the symbol's diagonal;
///   - facets of the patch that the eye sees nearly edge-on (kGrazingCosine): drafted side walls, say. Pocket walls run
///     along the rays, all but parallel to these;
///   - facets of the patch that face away from the one over the floor (kOppositeCosine): the far side of a sharp ridge.
///
/// Other facets of the patch are the surface that is carved: a floor is nearer to them than `minWallMm` as a rule.
///
/// **Method.** The distance d of a point from those facets changes by no more than the point moves. So the point goes
/// down its ray from the surface by d − minWall each time (sphere tracing), but by no less than half of
/// kDepthQuantumMm, so that it goes on along walls it runs parallel to. A submodule's limit is the least of its
/// corners, its centre and the middles of its sides: exact where surface and wall are plane there; elsewhere too deep
/// by no more than they bulge between points a quarter of a submodule apart, and too shallow by no more than half a
/// quantum.
///
/// Cost: one pass over the mesh, two trees over the facets near the carved region, one query for each of those points
/// or, near a wall, a dozen.
/// @param carved  size × size submodules; row-major from the symbol's top left
/// @returns for every submodule the limit in mm along its ray, 0 … maxDepthMm; 0 where nothing is carved or where the
///          patch does not cover it
std::vector<double> wallLimits(const Mesh& mesh, const VisiblePatch& patch, const ProjectionFrame& frame,
                               const SubmoduleMask& carved, const WallLimitOptions& options);

}  // namespace qrelief
