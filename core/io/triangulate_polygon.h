// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "math/vec.h"

namespace qrelief {

/// n - 2 triangles over a polygon's corners, in the polygon's own direction of rotation.
struct PolygonTriangles {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into the polygon's corners
  bool simple = true;     ///< false: no clean triangulation was found; the polygon crosses itself or has no area
  std::size_t tests = 0;  ///< steps that ear clipping took
};

/// Triangulates a polygon in its own plane (Newell's normal): a fan where that is valid (of a quadrilateral's two the
/// one with the shorter diagonal), else ear clipping [Meisters 1975] with the reflex corners in a tree of boxes.
/// Concave corners, straight corners and holes that are joined to the outline by a doubled edge are fine. The triangles
/// always span the same closed outline, so neighbouring polygons stay joined even where one is not simple.
///
/// Cost: O(n) for a fan, O(n log n) for ear clipping as a rule; never more than a fixed number of tests a corner, after
/// which the rest is fanned and `simple` is false.
/// @param corners  at least 3, finite
PolygonTriangles triangulatePolygon(std::span<const Vec3> corners);

}  // namespace qrelief
