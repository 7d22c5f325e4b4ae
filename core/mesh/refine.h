// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/mesh.h"

namespace qrelief {

/// The same surface with edges halved until none is longer than `longestMm`: both facets of an edge take its middle, so
/// that no T-junction arises. The original's vertices come first, unchanged.
///
/// Cost: O(T log(edge / longestMm)) for T triangles of the result.
/// @param longestMm      > 0
/// @param maxTriangles  it stops before a round that would give more
Mesh refineEdges(Mesh mesh, double longestMm, std::size_t maxTriangles);

}  // namespace qrelief
