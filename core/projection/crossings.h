// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "base/result.h"
#include "mesh/self_intersection.h"
#include "projection/silhouette.h"

namespace qrelief {

/// Adds to the silhouette the curves along which other facets pass through the patch. Where a surface crosses itself,
/// the eye may see another sheet beyond such a curve without a contour edge between. With these curves in the
/// silhouette, the guarantee of findSilhouette for a region that no silhouette segment enters also holds for such
/// models.
///
/// Two triangles that overlap in one plane add the sides of the other one if it faces the opposite way, as where a body
/// stands on the patch, else the sides of both; two that only touch add the segment
/// or the point of contact. Cost: one findCrossings of the patch, or a look at each known pair.
/// @param mesh   may cross itself
/// @param known  all crossing pairs of the mesh, see findCrossings(); null: searches the patch for them
/// @returns NoSolution if more than 100,000 pairs cross within the patch; Internal if the exact predicates fail
Status addCrossings(const Mesh& mesh, const ProjectionFrame& frame, VisiblePatch& patch,
                    const std::vector<TrianglePair>* known = nullptr);

/// Finds the point nearest to `place` at which other facets pass through the patch; none if no facet does.
///
/// Cost, errors and `known` as for addCrossings.
/// @param triangles  of the patch, ascending
Result<std::optional<Vec3>> nearestCrossing(const Mesh& mesh, std::span<const std::uint32_t> triangles, Vec3 place,
                                            const std::vector<TrianglePair>* known = nullptr);

}  // namespace qrelief
