// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace qrelief {

/// Finds vertices whose triangles certainly meet each other only at shared vertices and edges. Most vertices of a
/// smooth surface are such; the answer for others is no, whether their triangles meet or not.
///
/// **Proof.** A vertex counts if its triangles form cycles, each triangle followed by one across their common edge, and
/// if, seen along the sum of their normals, all are anticlockwise wedges and the direction of one edge lies in no wedge
/// but the two at that edge. Then the wedges turn once round the vertex, so no two overlap, and only neighbours touch,
/// along their common edge. Each triangle is seen one to one, so points that two triangles share are seen on that edge
/// and lie on it. All signs hold despite rounding.
///
/// Cost: O(T) and O(d²) for a vertex of d triangles; a vertex of more than 32 does not count. Runs on all cores.
/// @param triangles  only vertices of these are asked about, each with all its triangles in the mesh; empty: all
/// @returns for each vertex: 1 = certain
std::vector<std::uint8_t> simpleStars(const Mesh& mesh, std::span<const std::uint32_t> triangles = {});

}  // namespace qrelief
