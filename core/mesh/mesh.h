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
/// Positions are 32-bit floats because a binary STL holds nothing finer: what is welded, checked and
/// carved is then exactly what is written, and an untouched facet comes out bit for bit.
struct Mesh {
  std::vector<Vec3f> positions;
  std::vector<Triangle> triangles;

  Vec3 corner(std::size_t triangle, int k) const {
    return Vec3(positions[triangles[triangle][static_cast<std::size_t>(k)]]);
  }
};

Box3 boundingBox(const Mesh& mesh);

/// Signed volume, mm³; positive if the triangles face outwards. Closed meshes only.
double signedVolume(const Mesh& mesh);

/// Unit normal of a triangle; zero for one without area.
Vec3 triangleNormal(const Mesh& mesh, std::size_t triangle);

/// Angle-weighted unit vertex normals [Thürmer, Wüthrich 1998], one per vertex; zero where undefined.
std::vector<Vec3f> vertexNormals(const Mesh& mesh);

}  // namespace qrelief
