// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/topology.h"

namespace qrelief {

/// Defects that keep a mesh from being a closed manifold: the count and one place of each kind (meaningful if the count
/// is not 0).
struct Defects {
  std::size_t openEdges = 0;  ///< edges with one triangle
  std::size_t holes = 0;      ///< connected groups of open edges
  Vec3 openAt{0};
  std::uint32_t openTriangle = 0;    ///< there
  std::size_t nonManifoldEdges = 0;  ///< edges with three or more triangles
  Vec3 nonManifoldEdgeAt{0};
  std::vector<std::uint32_t> nonManifoldTriangles;  ///< there
  std::size_t nonManifoldVertices = 0;  ///< vertices whose triangles form several fans; counted in closed meshes only
  Vec3 nonManifoldVertexAt{0};
};

/// Finds a mesh's defects. Cost: O(T).
/// @param edges      of the mesh's triangles
/// @param adjacency  of the mesh's triangles
Defects findDefects(const Mesh& mesh, const EdgeTable& edges, const Adjacency& adjacency);

}  // namespace qrelief
