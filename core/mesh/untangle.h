// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "mesh/mesh.h"

namespace qrelief {

/// What became of a mesh's crossing triangles.
struct Untangling {
  std::size_t pairs = 0;    ///< how many crossed or touched, as findSelfIntersections counts them (not above its limit)
  bool atLeast = false;     ///< the count stopped at that limit
  Vec3 at{0};               ///< a corner of the first pair, before anything was moved
  bool tooCrowded = false;  ///< not all pairs could be looked at, so nothing was counted or moved
  bool mended = false;      ///< no pair is left; otherwise the mesh is as it was
  std::size_t moved = 0;    ///< vertices that lie elsewhere now
  double largestMoveMm = 0;
};

/// Parts the few triangles that cross in tiny tangles, as scans and filled holes have them: a vertex of each tangle is
/// moved towards the mean of its neighbours, in space or along its normal, by 1/64, 1/32, ... all of the way. Whether
/// that leaves nothing crossed is tried on the triangles around, with exact predicates, the shortest move first.
/// Nothing is moved unless everything can be mended within kUntangleEdgeFraction and kUntangleDiagonalFraction: parts
/// that overlap are left as they are.
///
/// Cost: one findSelfIntersections; with crossings O(T) for each tangle and a bounded number of tries.
/// @param mesh  welded, every triangle with an area; only positions are changed, and no triangle loses its area
/// @returns an error only if the exact predicates fail
Result<Untangling> untangle(Mesh& mesh);

}  // namespace qrelief
