// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "verification/reader_view.h"

namespace qrelief {

/// What a scanning app tries on one camera frame before it gives up: the picture as it is, contrast-stretched, out of
/// focus (which closes the gaps between the squares of a pattern), and from farther away. In this order; a reader that
/// reads any of them reads the code.
/// @param pixelsPerModule  of the code in the picture, > 0
std::vector<GreyImage> readingVariants(const GreyImage& picture, double pixelsPerModule);

/// The picture as a camera farther away sees it: means over larger pixels.
/// @param fraction  of its width, > 0; 1 or more: as it is
GreyImage fromFarther(const GreyImage& picture, double fraction);

}  // namespace qrelief
