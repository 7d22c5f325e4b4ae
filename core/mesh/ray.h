// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "mesh/mesh.h"

namespace qrelief {

/// A point of the surface.
struct SurfacePoint {
  Vec3 position;
  std::uint32_t triangle = 0;
  double distance = 0;  ///< from the ray's origin (ray) or the query point (closest)
};

/// First triangle that a ray meets, from either side. Watertight against shared edges in the sense that a ray
/// through an edge or vertex hits at least one of its triangles.
///
/// Cost: O(T), 3 ns a triangle or so: for single questions (a click, a centre), where building a tree would cost more.
/// @param direction  any length > 0
std::optional<SurfacePoint> firstHit(const Mesh& mesh, Vec3 origin, Vec3 direction);

/// Surface point nearest to `query`; ties go to the lower triangle index. Cost: O(T). Empty for an empty mesh.
std::optional<SurfacePoint> closestPoint(const Mesh& mesh, Vec3 query);

/// Unit normal of the surface at a point of it: within a facet the facet's; on an edge or vertex (to kOnSurfaceMm) the
/// mean of all facets that meet there, weighted by the angle at which they do [Thürmer, Wüthrich 1998]. The facet's own
/// where these cancel. Cost: O(T).
Vec3 surfaceNormalAt(const Mesh& mesh, const SurfacePoint& point);

}  // namespace qrelief
