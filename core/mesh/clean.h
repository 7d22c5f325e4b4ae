// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/topology.h"

namespace qrelief {

/// What cleanTriangles() did, with one example of each.
struct Cleaning {
  std::size_t degenerate = 0;  ///< triangles with collinear corners, dropped or mended
  std::size_t mended = 0;      ///< how many of these went into their neighbour by an edge flip
  std::size_t duplicates = 0;  ///< dropped triangles that had the same three vertices as another one
  std::optional<Vec3f> degenerateAt, duplicateAt;
  std::vector<std::uint32_t> origin;  ///< for each triangle that stayed, its number before; empty: all stayed
};

/// Drops triangles without area and triangles that repeat another one, the order of the rest kept.
///
/// A triangle that uses a vertex twice can always go. One with three different but collinear corners may be needed:
/// without it the long edge has a vertex in its middle (a T-junction). So they are dropped where that leaves a closed
/// surface; otherwise the neighbour over the long edge is split at the middle corner, which moves nothing:
///
///       d                d
///      / \              /|\        .
///     /   \     →      / | \       .
///    a-----c          a--b--c
///     (a b c: no area)
///
/// Of several triangles over the same corners one stays; or none, if they are a wall without thickness (see source).
/// Thin flaps that hang on an edge of a complete surface count as triangles without area (kFlapHeight).
///
/// Cost: O(T); with collinear triangles a few edge tables more.
/// @param mesh  welded
Cleaning cleanTriangles(Mesh& mesh);

/// False if no two triangles have the same three vertices: one look at each triangle's neighbours says so for most
/// meshes. Cost: O(T).
/// @param edges  of the triangles
bool mayHaveDuplicates(std::span<const Triangle> triangles, const EdgeTable& edges);

}  // namespace qrelief
