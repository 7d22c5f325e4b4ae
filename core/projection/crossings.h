// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "base/result.h"
#include "projection/silhouette.h"

namespace qrelief {

/// Adds to the silhouette the curves along which other facets come through those of the patch. Where a surface crosses
/// itself the eye may see another sheet beyond such a curve without a contour edge between; with these curves in the
/// silhouette, what findSilhouette says of a region that no silhouette segment enters is true of such models, too.
///
/// Two triangles that overlap in one plane give the sides of the one that belongs to the patch; two that only touch,
/// the segment or the point where they do. Cost: one findSelfIntersections of the patch.
/// @param mesh  may cross itself
/// @returns NoSolution if more than 100,000 pairs cross within the patch; Internal if the exact predicates fail
Status addCrossings(const Mesh& mesh, const ProjectionFrame& frame, VisiblePatch& patch);

/// The point nearest to a place at which other facets come through those of a patch; none if none does.
///
/// Cost and errors as of addCrossings.
/// @param triangles  of the patch, ascending
Result<std::optional<Vec3>> nearestCrossing(const Mesh& mesh, std::span<const std::uint32_t> triangles, Vec3 place);

}  // namespace qrelief
