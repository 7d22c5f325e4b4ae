// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "math/vec.h"
#include "mesh/mesh.h"

namespace qrelief {

inline constexpr std::uint32_t kNoNeighbour = 0xffffffffu;

struct PlaneTriangulation {
  std::vector<Triangle> triangles;                       ///< counter-clockwise, indices of the points
  std::vector<std::array<std::uint32_t, 3>> neighbours;  ///< triangle across the edge from corner k to corner k+1
};

/// Returns the constrained Delaunay triangulation of the points' convex hull, by exact predicates [CGAL, Chew 1989].
/// The result is unique, even with cocircular points, and in a fixed order.
///
/// Cost: O(n log n); 1 µs per point.
/// @param constraints  pairs of points; constraints may meet only at their ends
/// @returns Internal if two points coincide or two constraints cross
Result<PlaneTriangulation> triangulateConstrained(std::span<const Vec2> points,
                                                  std::span<const std::array<std::uint32_t, 2>> constraints);

}  // namespace qrelief
