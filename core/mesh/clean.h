// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/topology.h"

namespace qrelief {

/// Report of cleanTriangles(), with one example of each repair.
struct Cleaning {
  std::size_t degenerate = 0;  ///< triangles with collinear corners, dropped or repaired
  std::size_t mended = 0;      ///< of these, triangles merged into a neighbour by an edge flip
  std::size_t duplicates = 0;  ///< dropped triangles with the same three vertices as another triangle
  std::optional<Vec3f> degenerateAt, duplicateAt;
  std::vector<std::uint32_t> origin;  ///< for each remaining triangle, its index before; empty: all remain
  EdgeTable edges;                    ///< of the remaining triangles
};

/// Drops triangles without area and duplicate triangles. The rest keep their order.
///
/// A triangle that uses a vertex twice is always dropped. A triangle with three different but collinear corners may be
/// needed: without it the long edge has a vertex in its middle (a T-junction). It is dropped if the surface stays
/// closed; otherwise the neighbour across the long edge is split at the middle corner, which moves no vertex:
///
///       d                d
///      / \              /|\        .
///     /   \     →      / | \       .
///    a-----c          a--b--c
///     (a b c: no area)
///
/// Closed shells that touch are separated first (touching_shells.h): a face that each of them has is no duplicate.
/// Of several triangles with the same corners one stays, or none if they form a wall without thickness (see source).
/// Thin flaps attached to an edge of a complete surface count as triangles without area (kFlapHeight).
///
/// Cost: O(T); plus a few edge tables if there are collinear or repeated triangles.
/// @param mesh  welded
Cleaning cleanTriangles(Mesh& mesh);

/// Returns false only if no two triangles have the same three vertices. For most meshes a check of each triangle's
/// neighbours suffices. Cost: O(T).
/// @param edges  of the triangles
bool mayHaveDuplicates(std::span<const Triangle> triangles, const EdgeTable& edges);

}  // namespace qrelief
