// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "mesh/mesh.h"

namespace qrelief {

/// A point of the surface.
struct SurfacePoint {
  Vec3 position;
  std::uint32_t triangle = 0;
  double distance = 0;  ///< from the ray's origin (firstHit) or the query point (closestPoint)
};

/// Returns the first triangle that a ray meets, from either side. Watertight: a ray through an edge or vertex hits at
/// least one of its triangles.
///
/// Cost: O(T), some 3 ns per triangle. For single queries (a click, a centre), where building a tree would cost more.
/// @param direction  any length > 0
std::optional<SurfacePoint> firstHit(const Mesh& mesh, Vec3 origin, Vec3 direction);

/// Returns the surface point nearest to `query`; ties go to the lower triangle index. Cost: O(T). Empty for an empty
/// mesh.
std::optional<SurfacePoint> closestPoint(const Mesh& mesh, Vec3 query);

/// Returns the unit normal at a point of the surface: within a facet, the facet's normal; on an edge or vertex (to
/// kOnSurfaceMm), the mean normal of all facets that meet there, weighted by their angles [Thürmer, Wüthrich 1998], or
/// the facet's own if these cancel. Cost: O(T).
Vec3 surfaceNormalAt(const Mesh& mesh, const SurfacePoint& point);

/// A surface of triangles to query with many rays.
class RaySurface {
 public:
  virtual ~RaySurface() = default;

  /// Returns the first triangle met beyond `from` along the ray.
  /// @param direction  any length > 0
  /// @param from       in units of the direction's length, ≥ 0; nearer triangles are ignored
  virtual std::optional<SurfacePoint> firstHit(Vec3 origin, Vec3 direction, double from) const = 0;
  std::optional<SurfacePoint> firstHit(Vec3 origin, Vec3 direction) const { return firstHit(origin, direction, 0); }

  /// Returns the unit normal of the triangle that contains a point.
  virtual Vec3 normalAt(const SurfacePoint& at) const = 0;
};

}  // namespace qrelief
