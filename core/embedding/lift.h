// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "embedding/arrangement.h"
#include "math/frame.h"

namespace qrelief {

/// The arrangement back in space: the surface that replaces the footprint's facets.
struct LiftedSurface {
  /// A point of the arrangement at one level of depth.
  struct Vertex {
    std::uint32_t point = 0;
    int level = 0;
  };
  std::vector<Vertex> vertices;     ///< by point, then by level
  std::vector<Vec3f> positions;     ///< one for each; a model vertex at level 0 keeps its own bit for bit
  std::vector<Triangle> triangles;  ///< outward: tops and floors in the arrangement's order, then walls
  std::size_t firstWall = 0;        ///< index of the first wall's triangle

  /// Vertex of a point at level 0, which every point of the arrangement's triangles has, used or not.
  std::vector<std::uint32_t> surfaceVertex;
};

/// Lifts every point along its ray, once for each depth that meets there; floors are then shifted along their rays,
/// and walls, which stand on the outlines' pieces, run along rays. A wall's two ends carry every level that occurs
/// there, so that nothing meets in a T.
///
///     from|a ——— to|a        left deeper than right: the pocket is on the left, seen from there:
///       |      ／ |
///       |    ／  to|m        triangulated from top to bottom between the two chains of levels,
///       |  ／   ／ |         always along the shorter diagonal
///     from|b ——— to|b
///
/// Cost: O(arrangement).
LiftedSurface lift(const Mesh& mesh, const ProjectionFrame& frame, const Footprint& footprint,
                   const Arrangement& arrangement);

}  // namespace qrelief
