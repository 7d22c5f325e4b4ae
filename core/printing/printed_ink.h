// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/grid.h"
#include "label/text_outline.h"
#include "math/frame.h"
#include "printing/print_process.h"
#include "qr/symbol.h"

namespace qrelief {

/// A code in two materials to print.
struct PrintedInkRequest {
  PrintProcess process;
  Symbol symbol;             ///< only its size and colours are used
  double symbolMm = 0;       ///< edge without the quiet zone, on the QR plane, > 0
  std::vector<Ring> around;  ///< dark outlines outside the symbol, mm on the QR plane, filled on their left
  ProjectionFrame frame;
  Vec3 buildUp{0, 0, 1};  ///< the printer's vertical, any length > 0
  double bedMm = 0;       ///< height of the model's lowest point along the vertical
};

/// Grid of a square picture of the code, centred on it.
struct InkGrid {
  double pixelMm = 0.1;  ///< on the QR plane, > 0
  int pixels = 400;      ///< along the edge
};

/// Simulates how much of each pixel the printed code's dark material covers, as if the surface lay in the QR plane.
///
/// - A layer has the materials that the model has at half its height. On a surface at the angle θ to the horizontal,
///   layers are seen as strips layer/sin θ high: a tread, whose material lies half a layer lower, and a riser, which
///   shows one height.
/// - Within a layer a nozzle lays lines. Regions of either material that are narrower than a line are lost to the other
///   one, and corners are rounded [morphological opening of both]. In the plane the line's outline is an ellipse, cos θ
///   times as high as wide.
/// - The materials bleed into each other where they meet: the border is blurred by kBleedLines line widths. This is an
///   assumption; we know of no measurement.
///
/// Cost: O(pixels² · line/pixel), some 20 ms for a code of 29 modules.
/// @returns 0 … 1
BottomUp<float> printedInk(const PrintedInkRequest& request, const InkGrid& grid);

/// Standard deviation of the border between two materials, in line widths.
inline constexpr double kBleedLines = 0.15;

}  // namespace qrelief
