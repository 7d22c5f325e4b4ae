// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/mesh.h"
#include "mesh/topology.h"

namespace qrelief {

/// Returns the normal of the flat surface that a triangle belongs to: the mean, weighted by area, over the connected
/// triangles whose normals differ from its own by at most `toleranceDeg`. On a curved surface these are the triangles
/// close by.
///
/// Cost: O(triangles of the surface).
/// @param triangle  with an area > 0
/// @returns a unit vector
Vec3 flatRegionNormal(const Mesh& mesh, const Adjacency& adjacency, std::uint32_t triangle, double toleranceDeg = 3);

}  // namespace qrelief
