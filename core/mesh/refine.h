// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/mesh.h"

namespace qrelief {

/// Returns the same surface with edges halved until none is longer than `longestMm`. Both facets of an edge share its
/// midpoint, so no T-junction arises. The original vertices come first, unchanged.
///
/// Cost: O(T log(edge / longestMm)) for T triangles of the result.
/// @param longestMm      > 0
/// @param maxTriangles  stops before a round that would exceed this
Mesh refineEdges(Mesh mesh, double longestMm, std::size_t maxTriangles);

}  // namespace qrelief
