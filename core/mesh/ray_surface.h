// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "mesh/ray.h"

namespace qrelief {

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
