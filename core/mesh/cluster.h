// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace qrelief {

/// A coarser mesh and where each vertex went.
struct ClusteredMesh {
  Mesh mesh;
  std::vector<std::uint32_t> clusterOf;  ///< per vertex of the original: vertex of the coarser mesh
};

/// Merges the vertices of each cell of a cubic grid into their mean [Rossignac, Borrel 1993], but those apart whose
/// normals look the other way, so that the two sides of a thin wall do not become one. Facets that collapse, and pairs
/// that come to lie back to back, are dropped. For drawing and measuring roughly: the result need not be a manifold.
///
/// Cost: O(V log V + T).
/// @param normals  unit or zero, one per vertex
/// @param cellMm   edge of a cell, > 0
ClusteredMesh clusterVertices(const Mesh& mesh, std::span<const Vec3f> normals, double cellMm);

}  // namespace qrelief
