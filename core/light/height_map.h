// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "math/frame.h"

namespace qrelief {

/// A surface over the QR plane as the eye sees it, divided into square patches. Each patch is flat.
///
/// Heights are projective: w = eyeDistance²/depth − eyeDistance, where depth is the distance from the eye along the
/// normal. Near the QR plane w is the height over it. Central projection with w as the height maps lines to lines and
/// planes to planes, so a horizon seen along a line of the map is the horizon in space.
struct HeightMap {
  /// Height of a patch whose ray misses the surface: lower than any surface.
  static constexpr float kNothing = -1e6f;

  int size = 0;               ///< patches along the edge
  double patchMm = 0;         ///< edge of a patch on the QR plane
  double eyeDistance = 250;   ///< mm
  std::vector<float> height;  ///< w at the middles of the patches, mm, row-major from the lower left; or kNothing
  std::vector<float> slopeX, slopeY;  ///< slope of w to the right and up, mm per mm; 0 where there is no surface
  /// True if neighbouring patches meet at their border, as on a surface sampled at points. False if there may be walls
  /// there, along the rays.
  bool isContinuous = false;

  bool isSurface(std::size_t patch) const { return height[patch] > kNothing; }
};

/// Converts a surface map drawn from the eye to a height map.
/// @param surface  (facet normal in the frame's axes, height over the QR plane in mm) of size² texels, row-major from
///                 the lower left; the normal is zero where the ray misses the model (SurfaceMaps::surface)
HeightMap heightMapOf(std::span<const float> surface, int size, double patchMm, double eyeDistance);

}  // namespace qrelief
