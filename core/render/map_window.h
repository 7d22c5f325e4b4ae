// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "math/box.h"
#include "math/frame.h"

namespace qrelief {

/// The square of the QR plane that a map covers, centred on the code.
struct MapWindow {
  double extentMm = 0;  ///< edge of the square
  int texels = 0;       ///< along the edge; texel (0, 0) at the lower left

  double texelMm() const { return extentMm / texels; }
  /// Returns the plane point of a texel's middle.
  Vec2 planePoint(int column, int row) const {
    return {(column + 0.5) * texelMm() - extentMm / 2, (row + 0.5) * texelMm() - extentMm / 2};
  }
};

/// Returns the window, 256 texels wide, in which the eye sees the model around a map: the whole model, but at most 16
/// times the map's width.
MapWindow surroundingsOf(const MapWindow& map, const ProjectionFrame& frame, const Box3& model);

}  // namespace qrelief
