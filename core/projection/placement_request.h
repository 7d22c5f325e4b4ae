// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "math/vec.h"
#include "projection/direction.h"

namespace qrelief {

enum class SizeMode {
  Free,      ///< the largest that fits at every rotation
  Oriented,  ///< the largest that fits at the rotation asked for
  Best,      ///< the largest that fits at any rotation, and that rotation
  Fixed      ///< the size asked for, or an error that names the largest
};

/// "free", "oriented", "best", "fixed": names that scripts rely on.
const char* sizeModeName(SizeMode mode);

/// What found sizes must leave room for behind the surface.
struct PocketDemand {
  double minWallMm = 0;     ///< material that must remain, ≥ 0
  double depthModules = 0;  ///< pockets under every module, in modules; 0: walls do not count

  bool operator==(const PocketDemand&) const = default;
};

/// Where the code goes, which way it looks and how large it is.
struct PlacementRequest {
  Vec3 centreMm{0};  ///< moved to the nearest surface point
  SizeMode sizeMode = SizeMode::Free;
  double sizeMm = 0;      ///< Fixed: edge of the symbol without quiet zone, > 0
  double maxSizeMm = 60;  ///< upper bound of a found size, > 0
  bool quietZone = true;  ///< the quiet zone must fit, too
  Vec3 upHint{0, 0, 1};   ///< where the symbol's top points, projected onto the QR plane
  double rotateDeg = 0;   ///< then turned anticlockwise, as the reader sees it; Best: turned on from there
  DirectionMethod directionMethod = DirectionMethod::DepthBalanced;
  std::optional<Vec3> direction;  ///< towards the reader; overrides the method
  double eyeDistanceMm = 250;     ///< > 0
  double beyondMm = 0;   ///< the patch must be known this much farther than the largest code reaches, ≥ 0 (walls)
  PocketDemand pockets;  ///< of a size that is found; one that is asked for is carved as deep as its walls allow

  bool operator==(const PlacementRequest&) const = default;
};

/// How much larger than the symbol the square is that the surface must have room for: the quiet zone, or, without it,
/// the little that embedding may move the pockets' outlines by.
double roomFactor(int modules, bool quietZone);

}  // namespace qrelief
