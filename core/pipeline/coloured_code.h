// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/placement.h"
#include "settings/engrave_request.h"

namespace qrelief {

/// Number of layers that slicers print in the paint's colour under a facet that faces up: one more than the usual five
/// solid layers (PrusaSlicer 2.5, script/test-slicer).
inline constexpr int kPaintedLayers = 6;

/// A code in a second colour, before it is made.
struct ColouredCode {
  Mark mark = Mark::Inlay;  ///< Inlay or Paint
  LabelOptions label = {};
  PrinterRequest print = {};
};

/// Returns the code of a request in a second colour, or of one whose mark is open: then it is an inlay.
ColouredCode colouredCodeOf(const EngraveRequest& request);

/// Returns the number of layers that will contain the second colour of a code with its label and frame, as if the
/// surface was flat. Each costs about one filament change. 0 if the printer is not known.
/// @param modules  along the symbol's edge
int layersOfCode(const Placement& placement, int modules, const ColouredCode& code);

}  // namespace qrelief
