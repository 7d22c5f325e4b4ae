// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "light/directional_light.h"
#include "math/frame.h"
#include "viewer/orbit_camera.h"

namespace qrelief {

/// The hemisphere round a code, over its QR plane, on which the view shows the lamps.
struct LampHemisphere {
  ProjectionFrame frame;
  double radiusMm = 1;  ///< > 0

  /// Returns the unit vector to the lamp in model space.
  Vec3 direction(const DirectionalLight& lamp) const;
  Vec3 place(const DirectionalLight& lamp) const { return frame.centre + radiusMm * direction(lamp); }
  /// Moves a lamp to where a ray meets the hemisphere, in whole degrees. A ray that misses the sphere moves it to the
  /// sphere's nearest place, and a ray that meets the sphere only below the QR plane to the hemisphere's edge. Of two
  /// places, takes the one nearer to the lamp.
  DirectionalLight moved(const DirectionalLight& lamp, const Ray& ray) const;
};

}  // namespace qrelief
