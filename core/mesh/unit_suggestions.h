// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/message.h"
#include "math/vec.h"

namespace qrelief {

/// A unit in which a model would have a size that people print.
struct UnitSuggestion {
  std::string unit;  ///< "m", "in", "cm"
  double scaleToMm = 1;
  Vec3 sizeMm{0};  ///< of the model, read in this unit

  bool operator==(const UnitSuggestion&) const = default;
};

/// Units in which the longest side of a model would be 15 to 500 mm; at most two, of which none is the present one.
/// @param sizeMm     of the model as it is read now, longest side < 10 mm
/// @param scaleToMm  file units → mm, as it is read now
std::vector<UnitSuggestion> suggestUnits(Vec3 sizeMm, double scaleToMm);

/// What would help a model that is too small, to be told within another message: the units that were suggested, or, if
/// there is none, that the unit may be wrong.
Message unitAdvice(std::span<const UnitSuggestion> suggestions);

}  // namespace qrelief
