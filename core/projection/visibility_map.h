// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/result.h"
#include "math/frame.h"
#include "projection/direction.h"

namespace qrelief {

/// The surface that a frame's eye sees, and the part connected with the centre: a coarse form of the visible patch
/// (projection/silhouette.h), fast enough for every frame of an animation. Accurate to about a texel.
struct VisibilityMap {
  /// Height of a texel that shows no surface.
  static constexpr float kNothing = -1e6f;

  ProjectionFrame frame;
  MapWindow window;
  /// window.texels² values of (height over the QR plane, 1 = reached from the centre, slope along right, slope along
  /// up), row 0 at the bottom.
  std::vector<float> texels;

  bool isReached(int column, int row) const;
  float heightMm(int column, int row) const;

  /// Returns the edge of the largest square about the centre that is reached at every rotation, mm; within the window.
  double freeMm() const;
  /// Returns the edge of the largest reached square whose sides are turned anticlockwise from the frame's axes, mm.
  /// @param turn  radians
  double alignedMm(double turn) const;
  /// Returns the fraction of such a square that is not reached, 0 … 1.
  double missingFraction(double edgeMm, double turn) const;

  /// Returns the bend of the reached surface under such a square, mm (projection/flatness.h).
  double bendMm(double edgeMm, double turn) const;

  /// Marks everything the eye sees as reached, as in the exact patch.
  void trust();
};

/// Renders a window and floods it from the centre. The flood passes from texel to texel where the surface is less
/// oblique than kSteepest and does not jump. Cost: one rendering.
Result<VisibilityMap> lookAround(const SurfaceRenderer& surface, const ProjectionFrame& frame, const MapWindow& window);

}  // namespace qrelief
