// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "math/vec.h"

namespace qrelief {

/// The n - 2 triangles of a polygon with n corners, in the polygon's own direction of rotation.
struct PolygonTriangles {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into the polygon's corners
  bool simple = true;     ///< false: the polygon crosses itself or has no area, so no clean triangulation was found
  std::size_t tests = 0;  ///< number of ear-clipping steps
};

/// Triangulates a polygon in its own plane (Newell's normal). Uses a fan where one is valid (for a quadrilateral, the
/// fan with the shorter diagonal), otherwise ear clipping [Meisters 1975] with the reflex corners in a tree of boxes.
/// Concave corners, straight corners and holes joined to the outline by a doubled edge are fine. The triangles always
/// span the same closed outline, so neighbouring polygons stay joined even where one is not simple. A constrained
/// Delaunay triangulation could not do this (docs/decisions/0056).
///
/// Cost: O(n) for a fan, usually O(n log n) for ear clipping. The number of tests per corner is limited; beyond the
/// limit the rest becomes a fan and `simple` is false.
/// @param corners  at least 3, finite
PolygonTriangles triangulatePolygon(std::span<const Vec3> corners);

}  // namespace qrelief
