// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "base/random.h"
#include "light/directional_light.h"
#include "math/frame.h"
#include "mesh/ray.h"

namespace qrelief {

/// A distant disc-shaped lamp that shines in addition to the uniform sky. A lamp of strength 0 adds no light and costs
/// no rays; paths are the same as with the lamp on.
struct Lamp {
  Vec3 towards{0, 0, 1};  ///< unit, model space
  double strength = 0.5;  ///< irradiance of a surface that faces the lamp, 1 = irradiance by the whole sky; ≥ 0
  double radiusDeg = 20;  ///< 0 … 90, as seen from the model; 0: a point, with sharp shadows
};

/// Converts a lamp of a code to model space.
/// @param radiusDeg  see Lamp
Lamp lampOf(const DirectionalLight& light, const ProjectionFrame& frame, double radiusDeg);

/// The light of one path. 1 = the irradiance of an unoccluded surface under the sky alone.
struct LightPath {
  bool seesSky = false;   ///< the first ray leaves the model
  double sky = 0;         ///< from the sky, all bounces
  double lampDirect = 0;  ///< from the lamps without a bounce
  double lamp = 0;        ///< from the lamps, all bounces
};

/// Traces one path of light back from a point of the surface to sky and lamps, with every bounce (Russian roulette
/// after the third). Samples the lamps at each bounce [Kajiya 1986]. The mean over many paths is the light of the
/// surface.
/// @param at      a point of the surface
/// @param seen    direction in which it is seen: the light on that side of the facet counts
/// @param first   in [0, 1)²: chooses the first direction, cosine-weighted
/// @param albedo  reflectance of the matte material, 0 … 1
LightPath traceLight(const RaySurface& surface, SurfacePoint at, Vec3 seen, std::array<double, 2> first, double albedo,
                     std::span<const Lamp> lamps, Random& random);

}  // namespace qrelief
