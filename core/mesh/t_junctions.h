// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.h"

namespace qrelief {

/// What splitAtTJunctions() did.
struct TJunctionSplit {
  std::size_t vertices = 0;  ///< vertices that lay on an edge without being one of its ends
  double largestGapMm = 0;   ///< how far beside it
  Vec3 at{0};
  bool cutShort = false;              ///< not all vertices were looked at: too many open edges lie across each other
  std::vector<std::uint32_t> origin;  ///< for each triangle, the one it was part of; empty: nothing was split
};

/// Splits triangles at vertices that lie on one of their open edges, so that the edge's pieces find the pieces on the
/// other side:
///
///        c                c
///       / \              /|\        .
///      /   \     →      / | \       .
///     a-----b          a--v--b
///     d--v--e          d--v--e      (a = d, b = e)
///
/// Nothing is moved, and nothing done unless it leaves fewer open edges.
///
/// Cost: O(T) for each round, as many as a triangle has open edges; bounded for each vertex on an open edge.
/// @param toleranceMm  how far beside the edge and how near to its ends, ≥ 0
TJunctionSplit splitAtTJunctions(Mesh& mesh, double toleranceMm);

}  // namespace qrelief
