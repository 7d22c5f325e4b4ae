// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "projection/contour.h"

namespace qrelief {

/// The part of a contour edge that covers a facet, as the eye sees it.
struct Occluder {
  Segment2 segment;      ///< on the QR plane, mm; a point where the edge only touches the facet's image
  bool crosses = false;  ///< enters the image's interior; otherwise runs along the border or touches it
};

/// Returns the occluder if a contour edge passes over the closed facet nearer to the eye. An edge that starts at a
/// corner of the facet does so if it then runs over the facet (a cusp), but not if it leaves the facet at once. An edge
/// of the facet itself never does.
///
/// Exact predicates on the surface's own points, not on projections, decide on which side everything lies: two closed
/// convex shapes of the plane, a segment and a triangle, meet unless the line of one of their four sides separates
/// them. The crossing point is computed only for an edge that passes through the facet's plane. Because surfaces do not
/// cross, such an edge meets the facet's image either wholly in front or wholly behind.
///
/// @param triangle  faces the eye, Facing::Front
std::optional<Occluder> occluderOf(const Mesh& mesh, std::uint32_t triangle, const ContourEdge& edge, Vec3 eye,
                                   const ProjectionFrame& frame, const EyeView& view);

/// Tests if the interiors of the images of two facets, both Facing::Front, overlap; exact.
bool imagesOverlap(const Mesh& mesh, std::uint32_t first, std::uint32_t second, Vec3 eye);

/// Obstacle on the ray from the eye to the centre.
struct CentreObstruction {
  std::uint32_t triangle = 0;  ///< first triangle on the ray
  double fromEyeMm = 0;        ///< distance from the eye to it
  double clearDistanceMm = 0;  ///< an eye closer to the centre than this sees the centre
};

/// Finds the first obstacle between the eye and the centre; empty if the centre is visible. Cost: one box test per
/// facet, exact tests for the few that pass.
/// @param facets  all that may lie between eye and centre; `view` has them
std::optional<CentreObstruction> whatHidesCentre(const Mesh& mesh, const ProjectionFrame& frame, const EyeView& view,
                                                 std::span<const std::uint32_t> facets);

}  // namespace qrelief
