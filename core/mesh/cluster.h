// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace qrelief {

/// A coarser mesh, and the new vertex of each old one.
struct ClusteredMesh {
  Mesh mesh;
  std::vector<std::uint32_t> clusterOf;  ///< original vertex → vertex of the coarser mesh
};

/// Merges the vertices of each cell of a cubic grid into their mean [Rossignac, Borrel 1993]. Vertices whose normals
/// point the other way are kept apart, so that the two sides of a thin wall do not merge. Facets that collapse are
/// dropped, and so are pairs that end up back to back. The result is for drawing and rough measuring; it need not be a
/// manifold.
///
/// Cost: O(V log V + T).
/// @param normals  unit or zero, one per vertex
/// @param cellMm   edge of a cell, > 0
ClusteredMesh clusterVertices(const Mesh& mesh, std::span<const Vec3f> normals, double cellMm);

}  // namespace qrelief
