// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "mesh/ray.h"

namespace qrelief {

/// A surface of triangles that many rays are asked of.
class RaySurface {
 public:
  virtual ~RaySurface() = default;

  /// First triangle met, farther than `from` along the ray.
  /// @param direction  any length > 0
  /// @param from       in units of the direction's length, ≥ 0: what lies nearer is passed over
  virtual std::optional<SurfacePoint> firstHit(Vec3 origin, Vec3 direction, double from) const = 0;
  std::optional<SurfacePoint> firstHit(Vec3 origin, Vec3 direction) const { return firstHit(origin, direction, 0); }

  /// Unit normal of the triangle that a point lies in.
  virtual Vec3 normalAt(const SurfacePoint& at) const = 0;
};

}  // namespace qrelief
