// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/message.h"
#include "math/vec.h"

namespace qrelief {

/// A unit in which a model would have a printable size.
struct UnitSuggestion {
  std::string unit;  ///< "m", "in", "cm", "mm", "um"
  double scaleToMm = 1;
  Vec3 sizeMm{0};  ///< of the model in this unit

  bool operator==(const UnitSuggestion&) const = default;
};

/// Returns the units in which a model's longest side would be 15 to 500 mm: at most two, never the current unit.
/// @param sizeMm     current size of the model
/// @param scaleToMm  current scale, file units → mm
std::vector<UnitSuggestion> suggestUnits(Vec3 sizeMm, double scaleToMm);

/// Returns advice for a model that is too small, to be quoted within another message: the suggested units, or, without
/// any, that the unit may be wrong.
Message unitAdvice(std::span<const UnitSuggestion> suggestions);

/// Returns the same for a model that is too large.
Message smallerUnitAdvice(std::span<const UnitSuggestion> suggestions);

}  // namespace qrelief
