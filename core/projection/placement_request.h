// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "math/vec.h"
#include "projection/direction.h"

namespace qrelief {

enum class SizeMode {
  Best,      ///< as Oriented, or turned to fit if the code is then more than a ninth larger; a requested turn is kept
  Oriented,  ///< the largest size that fits at the requested rotation
  Free,      ///< the largest size that fits at every rotation [Papp 2022, §4]
  Fixed      ///< the requested size, or an error that names the largest
};

/// SizeMode::Best leaves a code upright if its size is at least this fraction of the turned code's.
inline constexpr double kUprightFraction = 0.9;

/// Returns "best", "oriented", "free" or "fixed". Scripts rely on these names.
const char* sizeModeName(SizeMode mode);

/// Material that a found size needs behind the surface.
struct PocketDemand {
  double minWallMm = 0;     ///< material that must remain, ≥ 0
  double depthModules = 0;  ///< pocket depth, in modules ...
  double depthMm = 0;       ///< ... and depth added to it at every module size; both 0: walls are ignored

  double depth(double moduleMm) const { return depthModules * moduleMm + depthMm; }

  bool operator==(const PocketDemand&) const = default;
};

/// The requested centre, direction and size of a code.
struct PlacementRequest {
  Vec3 centreMm{0};  ///< moved to the nearest surface point
  SizeMode sizeMode = SizeMode::Best;
  double sizeMm = 0;      ///< Fixed: edge of the symbol without quiet zone, > 0
  double maxSizeMm = 40;  ///< upper bound of a found size, > 0; larger codes need deeper pockets and decode no better
  bool quietZone = true;  ///< the quiet zone must fit, too
  Vec3 upHint{0, 0, 1};   ///< direction of the symbol's top, projected onto the QR plane
  double rotateDeg = 0;   ///< further anticlockwise turn, as the viewer sees it
  DirectionMethod directionMethod = DirectionMethod::DepthBalanced;
  std::optional<Vec3> direction;  ///< towards the viewer; overrides the method
  double eyeDistanceMm = 250;     ///< > 0
  double beyondMm = 0;            ///< margin of the known patch beyond the largest code, ≥ 0 (for walls)
  /// Width that a label needs on each side of the symbol, in modules, with the quiet zone; 0: no label.
  double labelMarginModules = 0;
  bool isText = false;   ///< a text in place of the symbol; changes only the words of messages, and needs no even light
  PocketDemand pockets;  ///< for found sizes only; a fixed size is carved as deep as its walls allow

  /// Returns true if the search may turn the code.
  bool mayTurn() const { return sizeMode == SizeMode::Best && rotateDeg == 0; }

  bool operator==(const PlacementRequest&) const = default;
};

/// Returns the edge of the square that must fit on the surface, in edges of the symbol: the symbol with its quiet zone
/// and label, or, without both, with the small margin by which embedding may move the pockets' outlines.
double roomFactor(int modules, const PlacementRequest& request);

}  // namespace qrelief
