// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "math/vec.h"

namespace qrelief {

/// Maps a point p to p.x·x + p.y·y + p.z·z + origin, like the rows of a 3MF transform.
struct Affine {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin{0};

  Vec3 operator()(Vec3 p) const { return p.x * x + p.y * y + p.z * z + origin; }
  /// Returns the map that applies `inner` first and then this one.
  Affine after(const Affine& inner) const;
  double determinant() const;
  /// Returns the map that undoes this one; the determinant must not be 0.
  Affine inverse() const;

  bool operator==(const Affine&) const = default;
};

/// Returns the rotation about the origin by the least angle that turns `up` to +z; about x if `up` is −z.
/// @param up  any length > 0
Affine turnedUp(Vec3 up);

}  // namespace qrelief
