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
  double maxDepthMm = 0;  ///< greatest depth of any submodule, along its ray, ≥ 0
  double minWallMm = 0;   ///< material that must remain around every floor, in any direction, ≥ 0
};

/// Finds the greatest depth of each submodule that leaves a wall of `minWallMm` [Papp 2022, §7: thickness; here in
/// every direction, not only along the ray]: no point of its floor, at that depth or on the way there, comes nearer
/// than `minWallMm` to the other side of the material. The pocket's walls are swept by the floor's rim on its way down,
/// so they keep the same distance. Other sides are
///
///   - facets of other bodies within the carved body's bounding box. Such a body may be a cavity that is not turned
///     inside out;
///   - facets of the same body outside the visible patch: its back, its sides beyond the silhouette, its cavities,
///     everything of it that the eye cannot see. Front-facing facets outside the patch's radius do not count, because
///     nothing is known about them: choose that radius `minWallMm + maxDepthMm` larger than half the symbol's diagonal;
///   - facets of the patch that the eye sees nearly edge-on (kGrazingCosine), such as drafted side walls. Pocket walls
///     run along the rays, almost parallel to these;
///   - facets of the patch that face away from the facet over the floor (kOppositeCosine): the far side of a sharp
///     ridge.
///
/// Other facets of the patch are the carved surface itself; a floor is usually nearer to them than `minWallMm`. A floor
/// may touch further bodies, which lie partly in the material, but not enter them: slicers print the union, so they
/// would fill the pocket there.
///
/// **Method.** The distance d of a point from those facets changes by no more than the point moves. So the point
/// descends its ray from the surface by d − minWall each time (sphere tracing), but by at least half of
/// kDepthQuantumMm, so that it keeps moving along walls parallel to it. A submodule's limit is the least limit of its
/// corners, its centre and the middles of its sides. It is exact where surface and wall are plane. Elsewhere it is too
/// deep by at most the bulge between points half a submodule apart, and too shallow by at most half a quantum.
///
/// Cost: one pass over the mesh, two trees over the facets near the carved region, one query for each of those points
/// or, near a wall, a dozen.
/// @returns for every submodule the limit in mm along its ray, 0 … maxDepthMm; 0 where nothing is carved or where the
///          patch does not cover it
std::vector<double> wallLimits(const Mesh& mesh, const VisiblePatch& patch, const ProjectionFrame& frame,
                               const SubmoduleMask& carved, const WallLimitOptions& options);

}  // namespace qrelief
