// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "qr/symbol.h"

namespace qrelief {

/// What the print must keep of the design's contrast. Nozzles round walls and fill corners, so that a module carved
/// with the least depth for a contrast of 0.3 prints with 0.15 to 0.19, the less the more the ground is curved. Codes
/// whose modules all keep two thirds read as well as those that were carved deeper all over (bench/printing/README.md).
inline constexpr double kPrintedShare = 2.0 / 3;

/// The contrast to ask of each module of the design, so that its print is dark enough: what its print lacks of
/// kPrintedShare comes on top. No module is asked for less than before: the design has to read, too.
///
/// A module's contrast is 1 − M/A, M its light through a verifier's aperture, A that of its surroundings
/// (carving/light_neighbours.h). The print's is measured by the design's mean, that of finders and that of other
/// modules, as their patterns differ.
///
/// @param designed, printed  light of the submodules of symbol and quiet zone, carved with `contrast` asked of all;
///                           row-major from the quiet zone's top left, 1 = unoccluded
/// @returns row-major from the symbol's top left, for FastSearchOptions::contrastOfModule
std::vector<double> contrastForPrint(const Symbol& symbol, const std::vector<double>& designed,
                                     const std::vector<double>& printed, double contrast);

}  // namespace qrelief
