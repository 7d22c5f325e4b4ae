// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/box.h"
#include "math/vec.h"

namespace qrelief {

using Triangle = std::array<std::uint32_t, 3>;  ///< vertex indices, counter-clockwise seen from outside

/// Indexed triangles in millimetres.
///
/// Positions are 32-bit floats because a binary STL holds nothing finer. The mesh that is welded, checked and carved is
/// then exactly the mesh written, and an untouched facet comes out bit for bit.
struct Mesh {
  std::vector<Vec3f> positions;
  std::vector<Triangle> triangles;
  /// Triangle → body (mesh/prepare.h); bodies share no vertex. Empty: all triangles are of body 0.
  std::vector<std::uint32_t> bodyOf = {};

  Vec3 corner(std::size_t triangle, int k) const { return Vec3(positions[triangles[triangle][k]]); }
  std::uint32_t body(std::size_t triangle) const { return bodyOf.empty() ? 0 : bodyOf[triangle]; }
};

Box3 boundingBox(const Mesh& mesh);

/// Returns the signed volume of a closed mesh, mm³; positive if the triangles face outwards.
double signedVolume(const Mesh& mesh);

/// Returns the unit normal of a triangle; zero for a triangle without area.
Vec3 triangleNormal(const Mesh& mesh, std::size_t triangle);

/// Returns angle-weighted unit vertex normals [Thürmer, Wüthrich 1998], one per vertex; zero where undefined.
std::vector<Vec3f> vertexNormals(const Mesh& mesh);

}  // namespace qrelief
