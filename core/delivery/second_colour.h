// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "printing/colour_changes.h"

namespace qrelief {

struct EngraveResult;

/// Cost of a result's second colour on the request's printer.
struct SecondColour {
  ColourCost cost;
  bool isPriced = false;  ///< true: the printer changes filaments, so that waste and minutes are known
};

/// Counts and prices the filament changes of a result. All zero for a result of one colour.
///
/// Cost: see colourCost().
SecondColour secondColourOf(const EngraveResult& result);

}  // namespace qrelief
