// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "label/text_outline.h"

namespace qrelief {

/// Frame round a code and its line of text.
enum class LabelFrame : std::uint8_t { None, Rounded, Square };

/// Returns "none", "rounded" or "square".
const char* labelFrameName(LabelFrame frame);

/// Marks outside a code's quiet zone: a line of text under it, and a frame round both. Or a text in place of a code.
struct LabelOptions {
  std::string text;  ///< UTF-8; empty: none
  LabelFrame frame = LabelFrame::None;
  bool isAlone = false;  ///< the text takes the place of the symbol; each of its lines is a line of letters

  bool empty() const { return text.empty() && frame == LabelFrame::None; }
  bool operator==(const LabelOptions&) const = default;
};

/// A rectangle with sides along the plane's axes.
struct Rectangle {
  Vec2 low{0}, high{0};
};

/// A label as polygons of the QR plane. The unit is a module; the symbol's centre is the origin, v points up.
struct LabelLayout {
  std::vector<Ring> rings;           ///< filled on their left; none cross
  std::vector<Rectangle> covered;    ///< rectangles that together cover everything filled
  double capitalModules = 0;         ///< height of a capital letter; 0: no text
  double thinnestStrokeModules = 0;  ///< of text and frame
};

/// Returns the width that a label needs on each side of a symbol, in modules, with the quiet zone. It is the same for
/// all texts, so that the codes of a batch have the same size. A text alone needs none.
double labelMarginModules(const LabelOptions& label, int modules);

/// Lays out a label: the text centred under the code, below the quiet zone, an eighth of the symbol high but at most as
/// wide as the symbol; the frame a module wide, outside quiet zone and text. A text alone fills the symbol's square in
/// one direction, with its frame; its lines are centred.
///
/// Cost: milliseconds.
/// @param modules  along the symbol's edge
/// @returns the errors of outlineText(); BadInput if the text has nothing to print, or a label several lines
Result<LabelLayout> layOutLabel(const LabelOptions& label, int modules);

/// Returns the least height of a capital letter whose strokes are a line wide, mm.
/// @param lineMm  width of the printer's line, > 0
double leastCapitalMm(double lineMm);

}  // namespace qrelief
