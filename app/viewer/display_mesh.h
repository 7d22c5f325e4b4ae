// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "math/frame.h"
#include "mesh/mesh.h"
#include "render/geometry_pass.h"

namespace qrelief {

/// A mesh for display. A vertex on a crease exists once for each smooth side of the crease.
struct DisplayMesh {
  Mesh mesh;                   ///< the same triangles in the same order
  std::vector<Vec3f> normals;  ///< unit, one per vertex; zero where undefined
};

/// Computes smooth normals that respect creases: a corner's normal is the angle-weighted mean over the facets around
/// its vertex whose normals differ from its own by less than the crease angle [Thürmer, Wüthrich 1998, for the
/// weights].
///
/// Cost: O(T · facets around a vertex).
/// @param creaseDeg  edges sharper than this stay sharp
DisplayMesh splitAtCreases(const Mesh& mesh, double creaseDeg = 40);

/// Gives a carved surface the smooth normals of the uncarved surface. Carving cuts facets whose normals were
/// interpolated across them; with normals of their own, the pieces would look like facets again. Walls keep their
/// normals.
///
/// @param firstTriangle  first of the triangles that carving made
/// @param smooth         window.texels² of (unit normal in the frame's axes, any) of the uncarved surface, row 0 at the
///                       bottom; zero where there is none
void takeSmoothNormals(DisplayMesh& carved, std::size_t firstTriangle, const ProjectionFrame& frame,
                       const MapWindow& window, std::span<const float> smooth, double creaseDeg = 40);

}  // namespace qrelief
