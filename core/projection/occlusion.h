// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "projection/contour.h"

namespace qrelief {

/// The part of a contour edge that lies, as the eye sees it, upon a facet.
struct Occluder {
  Segment2 segment;      ///< on the QR plane, mm; a point where the edge only touches the facet's image
  bool crosses = false;  ///< it enters the image's interior; otherwise it runs along the border or touches it
};

/// Whether a contour edge passes over the closed facet, nearer to the eye than it. An edge that starts at a corner of
/// the facet does so if it then runs over the facet (a cusp), not if it leaves it at once; an edge of the facet itself
/// never does.
///
/// Which side everything lies on is decided by exact predicates on the surface's own points, not on projections: two
/// closed convex shapes of the plane, a segment and a triangle, meet unless the line of one of their four sides parts
/// them. Only for an edge that passes through the facet's plane (then it meets the facet's image either wholly in
/// front or wholly behind, as surfaces do not cross) is the crossing point computed.
///
/// @param triangle  faces the eye, Facing::Front
std::optional<Occluder> occluderOf(const Mesh& mesh, std::uint32_t triangle, const ContourEdge& edge, Vec3 eye,
                                   const ProjectionFrame& frame, const EyeView& view);

/// Whether the images of two facets, both Facing::Front, share inner points; exact.
bool imagesOverlap(const Mesh& mesh, std::uint32_t first, std::uint32_t second, Vec3 eye);

/// What the ray from the eye to the centre meets before it comes there.
struct CentreObstruction {
  std::uint32_t triangle = 0;  ///< the nearest to the eye
  double fromEyeMm = 0;        ///< its distance from the eye
  double clearDistanceMm = 0;  ///< an eye nearer to the centre than this has a free view
};

/// Empty if the centre is seen. Cost: one box test a facet, exact tests for the few that pass.
std::optional<CentreObstruction> whatHidesCentre(const Mesh& mesh, const ProjectionFrame& frame, const EyeView& view);

}  // namespace qrelief
