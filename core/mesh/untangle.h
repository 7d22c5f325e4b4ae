// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/result.h"
#include "mesh/mesh.h"
#include "mesh/self_intersection.h"

namespace qrelief {

/// Report of untangle().
struct Untangling {
  std::size_t pairs = 0;    ///< pairs that crossed or touched, counted by findSelfIntersections() up to its limit
  bool atLeast = false;     ///< the count stopped at the limit
  Vec3 at{0};               ///< where the first pair crosses, before any move
  bool tooCrowded = false;  ///< too many pairs to examine, so nothing was counted or moved
  bool mended = false;      ///< no pair is left; if false, the mesh is unchanged
  std::vector<TrianglePair> left;  ///< the pairs counted, ascending; none if mended
  std::size_t moved = 0;           ///< number of moved vertices
  double largestMoveMm = 0;
};

/// Separates the few triangles that cross in tiny tangles, as in scans and filled holes. A vertex of each tangle is
/// moved towards the mean of its neighbours, in space or along its normal, by 1/64, 1/32, ... all of the permitted way.
/// Moves are tried shortest first; exact predicates on the triangles around decide whether any still cross. Nothing is
/// moved unless all tangles can be separated within kUntangleEdgeFraction and kMaxRepairMoveMm. Shells that overlap are
/// no tangle.
///
/// Cost: one findSelfIntersections(); plus, for each tangle, O(T) and a bounded number of tries.
/// @param mesh  welded, every triangle with an area. Only positions change, and no triangle loses its area
/// @returns an error only if the exact predicates fail
Result<Untangling> untangle(Mesh& mesh);

}  // namespace qrelief
