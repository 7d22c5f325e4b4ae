// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/result.h"
#include "mesh/prepare.h"
#include "projection/placement_request.h"

namespace qrelief {

/// Returns a phrase for the requested code, to be quoted within a message: "a code of 35 mm with its quiet zone".
Message codeInWords(const PlacementRequest& request);

/// A code that has no room.
struct NoRoom {
  const PreparedModel& model;
  const PlacementRequest& request;
  int modules = 0;               ///< along the symbol's edge
  std::optional<Vec3> crossing;  ///< the nearest place within the code where triangles cross, mm; none: they do not
};

/// Largest sizes of a symbol that fit, mm.
struct FittingSizes {
  double hereMm = 0;        ///< at the requested rotation
  double everywhereMm = 0;  ///< at every rotation
  double turnedMm = 0;      ///< at `turnedDeg`
  double turnedDeg = 0;     ///< the best rotation
};

/// Makes the error for a crossing so near to the centre that no code fits at any rotation. It names the crossing, not a
/// size. @param room  with a crossing
Error crossingAtCentre(const NoRoom& room, Vec3 centre);

/// Makes the error for a size that the request keeps too small. @param symbolMm  edge of the symbol
Error tooSmallAsAsked(const NoRoom& room, double symbolMm);

/// Makes the error for a spot at which only a symbol of too small a size fits. @param symbolMm  edge of the symbol
Error tooSmallHere(const NoRoom& room, double symbolMm);

/// Makes the error for a fixed size that does not fit. It names sizes that still fit as written: rounded down.
Error tooLarge(const NoRoom& room, const FittingSizes& fitting);

}  // namespace qrelief
