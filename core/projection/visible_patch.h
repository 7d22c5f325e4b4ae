// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "base/result.h"
#include "math/frame.h"
#include "mesh/topology.h"

namespace qrelief {

using Segment2 = std::array<Vec2, 2>;  ///< in plane coordinates, mm

/// The facets that can take the code, and their outline.
struct VisiblePatch {
  std::vector<std::uint32_t> triangles;  ///< ascending; their projections do not overlap
  std::vector<Segment2> silhouette;      ///< outer contour and inner occlusion contours, unordered
};

/// Facets wholly visible from the frame's eye and connected (across edges) with the seed [Papp 2022, §4]: flooding
/// from the seed over front-facing facets, stopping at every facet that a nearer contour edge crosses.
/// … proof that this is exact belongs here …
///
/// @param seed      triangle under the centre
/// @param radiusMm  facets wholly farther than this from the centre on the QR plane are left out; their edge is no
///                  silhouette
/// @returns NoSolution if the seed faces away from the eye or something hides it (says what)
Result<VisiblePatch> findVisiblePatch(const Mesh& mesh, const Adjacency& adjacency, const ProjectionFrame& frame,
                                      std::uint32_t seed, double radiusMm);

}  // namespace qrelief
