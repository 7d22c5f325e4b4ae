// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "math/vec.h"

namespace qrelief {

/// A shear that makes a ray the z axis: the ray hits a triangle if the origin lies in its projection [Woop, Benthin,
/// Wald 2013, Watertight ray/triangle intersection]. Each vertex is sheared once and each edge gives its two triangles
/// the same product with opposite signs, so no ray slips through between them.
class ShearedRay {
 public:
  ShearedRay(Vec3 origin, Vec3 direction) : origin_(origin) {
    const Vec3 size = glm::abs(direction);
    z_ = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    shear_ = {direction[x_] / direction[z_], direction[y_] / direction[z_], 1 / direction[z_]};
  }

  /// Returns the sheared point: x, y across the ray; z along it, in units of the direction's length.
  Vec3 apply(Vec3 p) const {
    const Vec3 q = p - origin_;
    return {q[x_] - shear_.x * q[z_], q[y_] - shear_.y * q[z_], shear_.z * q[z_]};
  }

 private:
  Vec3 origin_, shear_;
  int x_, y_, z_;
};

/// Returns the distance along the ray to the sheared triangle a, b, c, in units of the direction's length; negative if
/// the ray misses.
inline double hitParameter(Vec3 a, Vec3 b, Vec3 c) {
  constexpr double kMiss = -1;
  const double u = c.x * b.y - c.y * b.x;
  const double v = a.x * c.y - a.y * c.x;
  const double w = b.x * a.y - b.y * a.x;
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return kMiss;
  const double sum = u + v + w;
  if (sum == 0) return kMiss;  // seen edge-on: the ray hits its neighbours
  return (u * a.z + v * b.z + w * c.z) / sum;
}

}  // namespace qrelief
