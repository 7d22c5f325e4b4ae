// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/affine.h"

namespace qrelief {

Affine Affine::after(const Affine& inner) const {
  const auto turned = [this](Vec3 v) { return v.x * x + v.y * y + v.z * z; };
  return {turned(inner.x), turned(inner.y), turned(inner.z), (*this)(inner.origin)};
}

double Affine::determinant() const { return glm::dot(glm::cross(x, y), z); }

Affine Affine::inverse() const {
  const Vec3 yz = glm::cross(y, z) / determinant(), zx = glm::cross(z, x) / determinant(),
             xy = glm::cross(x, y) / determinant();
  const Affine turned{{yz.x, zx.x, xy.x}, {yz.y, zx.y, xy.y}, {yz.z, zx.z, xy.z}};
  return {turned.x, turned.y, turned.z, -turned(origin)};
}

Affine turnedUp(Vec3 up) {
  up = glm::normalize(up);
  const double squaredSine = up.x * up.x + up.y * up.y;
  if (up.z < 0 && squaredSine == 0) return {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}, Vec3(0)};
  // Rodrigues' formula with the axis up × z, whose length is the angle's sine. The scale is 1 / (1 + up.z).
  const double scale = up.z < 0 ? (1 - up.z) / squaredSine : 1 / (1 + up.z);
  return {{1 - scale * up.x * up.x, -scale * up.x * up.y, up.x},
          {-scale * up.x * up.y, 1 - scale * up.y * up.y, up.y},
          {-up.x, -up.y, up.z},
          Vec3(0)};
}

}  // namespace qrelief
