// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "pipeline/placement.h"
#include "printing/colour_changes.h"

namespace qrelief {

struct EngraveResult;
struct PrinterRequest;

/// Number of layers that slicers print in the paint's colour under a facet that faces up: one more than the usual five
/// solid layers (PrusaSlicer 2.5, script/test-slicer).
inline constexpr int kPaintedLayers = 6;

/// Cost of a result's second colour on the request's printer.
struct SecondColour {
  ColourCost cost;
  bool isPriced = false;  ///< true: the printer changes filaments, so that waste and minutes are known
};

/// Counts and prices the filament changes of a result. All zero for a result of one colour.
///
/// Cost: see colourCost().
SecondColour secondColourOf(const EngraveResult& result);

/// Returns the number of layers that a code's square passes through, on its plane. With a second colour, each layer
/// costs about one filament change. 0 if the printer is not known.
int layersOfCode(const Placement& placement, const PrinterRequest& print);

}  // namespace qrelief
