// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/objects.h"
#include "math/vec.h"
#include "mesh/mesh.h"
#include "viewer/orbit_camera.h"

namespace qrelief {

/// The plate of a printer under a model.
struct BuildPlate {
  Vec3 centre{0};                      ///< of the model's footprint on the plate
  Vec3 right{1, 0, 0}, back{0, 1, 0};  ///< axes of the plate, unit
  Vec3 up{0, 0, 1};                    ///< the printer's vertical, unit
  Vec2 halfMm{0};                      ///< half edges of the footprint: of the model's box, seen from above
  double heightMm = 0;                 ///< of the model over the plate

  bool operator==(const BuildPlate&) const = default;
};

/// Returns the plate that a model stands on. Cost: O(vertices).
/// @param up  the printer's vertical in the model's space, any length > 0
BuildPlate plateUnder(const Mesh& mesh, Vec3 up);

/// Draws the plate over a presented picture: a grid of 10 mm, its tenth lines stronger, that fades out around the
/// footprint. The model hides it. Seen from below, it is fainter.
/// @param program  view_plate, with the uniforms of view_sight.glsl set
void drawPlate(const gl::Program& program, const BuildPlate& plate, const CameraView& camera, bool dark);

}  // namespace qrelief
