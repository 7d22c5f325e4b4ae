// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "base/result.h"
#include "math/vec.h"

namespace qrelief {

/// A closed polygon; its last corner is joined to its first.
using Ring = std::vector<Vec2>;

/// Text as polygons. The unit is the height of a capital letter; the first letter's pen starts at (0, 0), on the
/// baseline.
struct TextOutline {
  std::vector<Ring> rings;  ///< filled on their left: anticlockwise outside, clockwise round holes; none cross
  Vec2 low{0}, high{0};     ///< corners of the rings' bounding box; both zero if there are no rings
};

/// Thinnest straight stroke of the font, in capital heights: the bar of its H.
double thinnestStroke();

/// Outlines a line of text in Open Sans Bold, which is compiled in, with the font's kerning [by FreeType]. Glyphs are
/// at least a tenth of a capital height apart. Curves become chords.
///
/// Cost: milliseconds.
/// @param text       UTF-8, composed or not
/// @param tolerance  farthest that a chord may be from its curve, in capital heights, > 0
/// @returns BadInput if the text is not UTF-8, or if the font lacks characters (the message names them)
Result<TextOutline> outlineText(std::string_view text, double tolerance);

}  // namespace qrelief
