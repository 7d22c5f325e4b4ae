// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "verification/reader_view.h"

namespace qrelief {

/// Returns the variants of a camera frame that a scanning app tries before it gives up: the picture as it is,
/// contrast-stretched, out of focus (which closes the gaps between the squares of a pattern), and from farther away, in
/// this order. A decoder that reads any of them reads the code.
/// @param pixelsPerModule  resolution of the code in the picture, > 0
std::vector<GreyImage> readingVariants(const GreyImage& picture, double pixelsPerModule);

/// Returns the picture as a camera farther away sees it, as means over larger pixels.
/// @param fraction  of the picture's width, > 0; 1 or more: unchanged
GreyImage fromFarther(const GreyImage& picture, double fraction);

}  // namespace qrelief
