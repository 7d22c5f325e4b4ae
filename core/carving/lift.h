// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "carving/arrangement.h"
#include "math/frame.h"

namespace qrelief {

/// The arrangement lifted into space: the surface that replaces the footprint's facets.
struct LiftedSurface {
  /// A point of the arrangement at one depth level.
  struct Vertex {
    std::uint32_t point = 0;
    int level = 0;
  };
  std::vector<Vertex> vertices;     ///< sorted by point, then by level
  std::vector<Vec3f> positions;     ///< one per vertex; a model vertex at level 0 keeps its position bit for bit
  std::vector<Triangle> triangles;  ///< facing outwards: tops and floors in the arrangement's order, then walls
  std::size_t firstWall = 0;        ///< index of the first wall's triangle

  /// Point → its vertex at level 0; every point of the arrangement's triangles has one, used or not.
  std::vector<std::uint32_t> surfaceVertex;
};

/// Lifts every point along its ray, once for each depth that occurs there. Floors are thus shifted along their rays,
/// and the walls at the outlines' pieces run along rays. Both ends of a wall have a vertex at every level that occurs
/// there, so that no T-junction arises.
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
