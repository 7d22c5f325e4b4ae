// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/result.h"
#include "math/frame.h"
#include "projection/direction.h"

namespace qrelief {

/// What the eye of a frame sees, and which of it hangs together with the centre: a coarse picture of the visible patch
/// (projection/silhouette.h) that is made within one frame of an animation. Right to about a texel.
struct EyeReach {
  /// Of the maps: heights of texels that meet nothing.
  static constexpr float kNothing = -1e6f;

  ProjectionFrame frame;
  MapWindow window;
  /// window.texels²·(height over the QR plane, 1 = reached from the centre, slope along right, slope along up), row 0
  /// at the bottom.
  std::vector<float> texels;

  bool isReached(int column, int row) const;

  /// Edge of the largest square about the centre that is reached at every rotation; within the window.
  double freeMm() const;
  /// Edge of the largest one whose sides are turned anticlockwise from the frame's axes, radians.
  double alignedMm(double turn) const;
  /// Fraction of such a square that is not reached, 0 … 1.
  double missingFraction(double edgeMm, double turn) const;

  /// All that the eye sees counts as reached, as the exact patch says.
  void trust();
};

/// Looks at a window and floods it from the centre: from texel to texel where the surface is seen at less
/// than kSteepest and does not jump. Cost: one look.
Result<EyeReach> lookAround(const SurfaceLook& look, const ProjectionFrame& frame, const MapWindow& window);

}  // namespace qrelief
