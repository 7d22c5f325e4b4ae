// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/mesh.h"

namespace qrelief {

/// A mesh to be looked at: vertices on creases are there once for each smooth side of them.
struct DisplayMesh {
  Mesh mesh;                   ///< the same triangles in the same order
  std::vector<Vec3f> normals;  ///< unit, one per vertex; zero where undefined
};

/// Smooth normals that respect creases: a corner's normal is the angle-weighted mean over those facets around its
/// vertex that differ from its own by less than the crease angle [Thürmer, Wüthrich 1998, for the weights].
///
/// Cost: O(T · facets around a vertex).
/// @param creaseDeg  edges sharper than this stay sharp
DisplayMesh splitAtCreases(const Mesh& mesh, double creaseDeg = 40);

}  // namespace qrelief
