// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec4.hpp>

#include "gl/objects.h"
#include "math/vec.h"
#include "viewer/orbit_camera.h"

namespace qrelief {

/// A rectangle with a grid of 10 mm, its tenth lines stronger, that fades out in a margin around it.
struct GridPlane {
  Vec3 centre{0};                      ///< mm, model space
  Vec3 right{1, 0, 0}, back{0, 1, 0};  ///< its axes, unit
  Vec2 halfMm{0};                      ///< half edges
  double fadeMm = 15;                  ///< width of the margin
  glm::vec4 line{0}, ground{0};        ///< sRGB colour and opacity, of the lines and between them

  bool operator==(const GridPlane&) const = default;
};

/// Draws the plane over a presented picture. The model hides it.
/// @param program  view_plate, with the uniforms of view_sight.glsl set
void drawGridPlane(const gl::Program& program, const GridPlane& plane, const CameraView& camera);

}  // namespace qrelief
