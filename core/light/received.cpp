// SPDX-License-Identifier: GPL-3.0-or-later
#include "light/received.h"

#include <algorithm>
#include <cmath>

namespace qrelief {
namespace {

// As in shaders/interreflection.glsl.
constexpr float kWall = 0.401f, kWallAlbedo = 0.75f, kFarSurface = 0.910f;

}  // namespace

float interreflection(float visibility, float pastWalls, float albedo) {
  const float wall = kWall / (1 - kWallAlbedo * albedo) * std::sqrt(std::max(visibility, 0.0f));
  return albedo * ((1 - pastWalls) * wall + std::max(pastWalls - visibility, 0.0f) * kFarSurface);
}

float luminanceOf(const Received& received, float albedo, float openIrradiance) {
  const float reflected = (1 + received.lampsUncarved) * interreflection(received.sky, received.pastWalls, albedo);
  return (received.sky + received.lamps + reflected) / openIrradiance;
}

}  // namespace qrelief
