// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace qrelief {

/// Report of splitAtTJunctions().
struct TJunctionSplit {
  std::size_t vertices = 0;  ///< vertices that lay on an edge but were not its ends
  double largestGapMm = 0;   ///< largest distance of such a vertex from its edge
  Vec3 at{0};
  bool cutShort = false;              ///< not all vertices were examined: too many open edges lie across each other
  std::vector<std::uint32_t> origin;  ///< for each triangle, the original that it was part of; empty: nothing was split
};

/// Splits triangles at vertices that lie on one of their open edges, so that the edge's pieces match the pieces on the
/// other side:
///
///        c                c
///       / \              /|\        .
///      /   \     →      / | \       .
///     a-----b          a--v--b
///     d--v--e          d--v--e      (a = d, b = e)
///
/// Moves no vertex, and changes nothing unless fewer open edges remain.
///
/// Cost: O(T) per round, with as many rounds as a triangle has open edges; bounded for each vertex on an open edge.
/// @param toleranceMm     largest distance from the edge, and least distance from its ends, ≥ 0
/// @param bodyOfTriangle  empty: one body. A vertex of one body splits no triangle of another
TJunctionSplit splitAtTJunctions(Mesh& mesh, double toleranceMm, std::span<const std::uint32_t> bodyOfTriangle = {});

}  // namespace qrelief
