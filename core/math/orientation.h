// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "math/vec.h"

namespace qrelief {

namespace detail {

/// Computes sideOfPlane without the filter.
int exactSideOfPlane(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

}  // namespace detail

/// Returns the side of the plane through a, b, c on which the point d lies, exactly: +1 where a, b, c turn
/// counter-clockwise seen from d, -1 on the other side, 0 in the plane.
///
/// Seen from an eye E, `sideOfPlane(a, b, x, E)` is the side of the projected line ab on which the projection of x lies
/// (+1 = left). No projection is computed.
///
/// Cost: one determinant. Exact arithmetic (CGAL, EPICK) runs only where the sign is uncertain: where the determinant
/// is smaller than Shewchuk's bound (7 + 56ε)·ε·permanent on its rounding error, ε = 2^-53 [Shewchuk 1997, orient3d A].
inline int sideOfPlane(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 p = a - d;
  const Vec3 q = b - d;
  const Vec3 r = c - d;
  const double qxry = q.x * r.y, rxqy = r.x * q.y;
  const double rxpy = r.x * p.y, pxry = p.x * r.y;
  const double pxqy = p.x * q.y, qxpy = q.x * p.y;
  const double determinant = p.z * (qxry - rxqy) + q.z * (rxpy - pxry) + r.z * (pxqy - qxpy);
  const double permanent = (std::abs(qxry) + std::abs(rxqy)) * std::abs(p.z) +
                           (std::abs(rxpy) + std::abs(pxry)) * std::abs(q.z) +
                           (std::abs(pxqy) + std::abs(qxpy)) * std::abs(r.z);
  constexpr double kEpsilon = 0x1p-53;
  const double bound = (7 + 56 * kEpsilon) * kEpsilon * permanent;
  if (determinant > bound) return -1;
  if (-determinant > bound) return 1;
  return detail::exactSideOfPlane(a, b, c, d);
}

}  // namespace qrelief
