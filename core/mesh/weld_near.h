// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "mesh/mesh.h"

namespace qrelief {

/// What weldNear() did.
struct NearWelding {
  std::size_t moved = 0;  ///< vertices that became one with another
  double largestMoveMm = 0;
  Vec3 at{0};             ///< place of the first vertex that was moved
  bool cutShort = false;  ///< not all pairs were looked at: too many vertices lie on one spot
};

/// Makes vertices on open edges one if they lie within a tolerance of each other: the nearest first, and the one of the
/// lowest index stays where it is. Closed surfaces are not touched, however near they come to each other; nor are two
/// vertices of one triangle ever joined, so no triangle collapses; nor vertices of different parts.
///
/// Cost: O(T), and of the pairs within the tolerance; bounded for each vertex on an open edge.
/// @param toleranceMm     ≥ 0
/// @param partOfTriangle  empty: one part
NearWelding weldNear(Mesh& mesh, double toleranceMm, std::span<const std::uint32_t> partOfTriangle = {});

}  // namespace qrelief
