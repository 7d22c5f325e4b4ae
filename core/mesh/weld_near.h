// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "mesh/mesh.h"

namespace qrelief {

/// Report of weldNear().
struct NearWelding {
  std::size_t moved = 0;  ///< vertices merged into another
  double largestMoveMm = 0;
  Vec3 at{0};             ///< place of the first moved vertex
  bool cutShort = false;  ///< not all pairs were examined: too many vertices lie on one spot
};

/// Merges vertices on open edges that lie within a tolerance of each other, the nearest first. The vertex with the
/// lowest index stays in place. Never touches closed surfaces, however near each other; never joins two vertices of one
/// triangle, so no triangle collapses; never joins vertices of different bodies.
///
/// Cost: O(T), plus the pairs within the tolerance; bounded for each vertex on an open edge.
/// @param toleranceMm     ≥ 0
/// @param bodyOfTriangle  empty: one body
NearWelding weldNear(Mesh& mesh, double toleranceMm, std::span<const std::uint32_t> bodyOfTriangle = {});

}  // namespace qrelief
