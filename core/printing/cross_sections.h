// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "projection/plane_shapes.h"

namespace qrelief {

/// Parallel planes z = firstMm + k · stepMm that cut a model, k = 0 … count − 1.
struct CuttingPlanes {
  double firstMm = 0, stepMm = 0.2;
  int count = 0;

  double heightMm(int plane) const { return firstMm + plane * stepMm; }
  /// Returns the lowest plane above z; `count` if there is none. With a vertex in a plane counted as above it, the
  /// planes from firstAbove(low) to before firstAbove(high) cut a triangle that reaches from `low` to `high`.
  int firstAbove(double z) const;
};

/// Intersections of the planes with the triangles within a rectangle.
struct CrossSections {
  /// Per plane: segments with the solid on their left, seen from above. They form closed curves, except where a curve
  /// leaves the rectangle.
  std::vector<std::vector<Segment2>> outlines;
  /// Per plane: winding number at the rectangle's lower left corner; 0 = outside.
  std::vector<int> windings;
};

/// Cuts a closed mesh. A vertex in a plane counts as above it, so that every triangle gives one segment or none.
///
/// Cost: O(triangles + segments).
/// @param positions  in the printer's space
/// @param triangles  anticlockwise seen from outside
/// @param low, high  corners of the rectangle: triangles outside it are skipped; no vertex has the x and y of `low`
CrossSections cutByPlanes(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                          const CuttingPlanes& planes, Vec2 low, Vec2 high);

}  // namespace qrelief
