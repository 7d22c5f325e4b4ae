// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewer/orbit_camera.h"
#include "viewer/viewer.h"

namespace qrelief {

/// A rectangle of pixels, as glScissor counts them: from the lower left.
struct PixelBox {
  int x = 0, y = 0, width = 0, height = 0;

  bool operator==(const PixelBox&) const = default;
};

/// Where on the canvas view_print.frag may draw something of a print: its square over the heights that its reach
/// knows there, or, without one, over all that take a print; and its outline. Never too small.
/// @param width, height  of the canvas, pixels
/// @returns within the canvas; empty beside it
PixelBox printBounds(const SurfacePrint& print, const CameraView& camera, int width, int height);

}  // namespace qrelief
