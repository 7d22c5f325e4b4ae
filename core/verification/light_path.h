// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "base/random.h"
#include "light/directional_light.h"
#include "math/frame.h"
#include "mesh/ray_surface.h"

namespace qrelief {

/// A lamp beside the uniform sky: a disc, far away. One of strength 0 brings nothing and costs no rays; paths are the
/// same as with it on.
struct Lamp {
  Vec3 towards{0, 0, 1};  ///< unit, model space
  double strength = 0.5;  ///< irradiance of a surface that faces it, 1 = that of the whole sky; ≥ 0
  double radiusDeg = 20;  ///< 0 … 90, as seen from the model; 0: a point, with sharp shadows
};

/// Of BakeOptions, where there is to be none.
inline constexpr Lamp kNoLamp{.strength = 0, .radiusDeg = 0};

/// A lamp of a code, in model space. @param radiusDeg  see Lamp
Lamp lampOf(const DirectionalLight& light, const ProjectionFrame& frame, double radiusDeg);

/// What one path brings. 1 = the irradiance of an unoccluded surface under the sky alone.
struct LightPath {
  bool seesSky = false;   ///< the first ray leaves the model
  double sky = 0;         ///< from the sky, all bounces
  double lampDirect = 0;  ///< from the lamps without a bounce
  double lamp = 0;        ///< from the lamps, all bounces
};

/// One path of light, traced back from a point of the surface to sky and lamps, with every bounce (Russian roulette
/// after the third) and the lamps asked at each [Kajiya 1986]: its mean over many paths is the surface's light.
/// @param at      a point of the surface
/// @param seen    direction in which it is seen: the light on that side of the facet counts
/// @param first   in [0, 1)²: choose the first direction, cosine-weighted
/// @param albedo  of the matte material, 0 … 1
LightPath traceLight(const RaySurface& surface, SurfacePoint at, Vec3 seen, std::array<double, 2> first, double albedo,
                     std::span<const Lamp> lamps, Random& random);

}  // namespace qrelief
