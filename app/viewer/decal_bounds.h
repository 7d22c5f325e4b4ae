// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewer/orbit_camera.h"
#include "viewer/viewer.h"

namespace qrelief {

/// A rectangle of pixels, counted from the lower left as in glScissor.
struct PixelBox {
  int x = 0, y = 0, width = 0, height = 0;

  bool operator==(const PixelBox&) const = default;
};

/// Returns the part of the canvas where view_decal.frag may draw: the outline of a decal, and its square over the range
/// of heights that its reach knows there or, without a reach, over all heights that take a decal. Never too small.
/// @param width, height  of the canvas, pixels
/// @returns a box within the canvas; empty if the decal is off it
PixelBox decalBounds(const Decal& decal, const CameraView& camera, int width, int height);

}  // namespace qrelief
