// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <span>

#include "math/angle.h"
#include "math/vec.h"

namespace qrelief {

inline constexpr std::size_t kMaxLights = 2;

/// A lamp so far away that its rays are parallel, in addition to the uniform sky.
struct DirectionalLight {
  double azimuthDeg = 0;     ///< its direction around the code: 0 = right, 90 = top, as the viewer sees it
  double elevationDeg = 45;  ///< over the QR plane, 0 < e ≤ 90; 90 = at the viewer
  double strength = 1;       ///< irradiance of a surface that faces it, 1 = irradiance by the whole sky; ≥ 0

  bool operator==(const DirectionalLight&) const = default;
};

/// Returns the unit vector to the lamp in the frame's axes (right, up, normal).
inline Vec3 towards(const DirectionalLight& light) {
  const double azimuth = toRadians(light.azimuthDeg);
  const double elevation = toRadians(light.elevationDeg);
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

/// Returns the irradiance of an unoccluded surface in the QR plane under the sky and the lamps, 1 = under the sky
/// alone. Luminances are divided by it.
inline double openIrradiance(std::span<const DirectionalLight> lights) {
  double sum = 1;
  for (const DirectionalLight& light : lights) sum += light.strength * towards(light).z;
  return sum;
}

}  // namespace qrelief
