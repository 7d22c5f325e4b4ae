// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/self_intersection.h"

namespace qrelief {

using Segment3 = std::array<Vec3, 2>;

/// Returns the segments that two triangles of a pair of findCrossings() share. It is one segment, or a point, on the
/// line in which their planes meet: where the intervals overlap that the triangles cover of it [Möller 1997]. Of
/// triangles in one plane it is the sides of `b` that lie within `a`; if both face the same way, also the sides of `a`
/// that lie within `b`.
/// @param a, b  indices of triangles
/// @returns at least one segment; a point is a segment without length
std::vector<Segment3> crossingSegments(const Mesh& mesh, std::uint32_t a, std::uint32_t b);

/// Returns a point at which the two triangles of a pair of findCrossings() meet.
Vec3 crossingPoint(const Mesh& mesh, const TrianglePair& pair);

}  // namespace qrelief
