// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "mesh/mesh.h"
#include "mesh/topology.h"

namespace qrelief {

/// Gives shells that touch at faces, edges or vertices vertices of their own, so that each is a manifold. Around an
/// edge with four or more triangles, the two on either side of a piece of solid belong together; where two pieces of
/// solid meet face to face, each keeps its face. Welding alone would join the shells there and make them seem damaged.
///
/// An edge stays as it is if its triangles do not enclose solid and air in turn: one of them faces the wrong way, is
/// missing, or lies on another that faces the same way. So does an edge where one shell touches itself, if the shell
/// continues round both of its ends, and a vertex where one shell touches itself.
///
/// Cost: O(T log T), plus O(k log k) exact predicates (math/orientation.h) for k triangles round an edge.
/// @param mesh   welded, each triangle with three different vertices; new vertices come last
/// @param edges  of the mesh's triangles, before
/// @returns number of new vertices
std::size_t separateTouchingShells(Mesh& mesh, const EdgeTable& edges);

}  // namespace qrelief
