// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/grid.h"
#include "qr/symbol.h"

namespace qrelief {

/// Share of the design's contrast that the print must keep. Nozzles round walls and fill corners: a module carved with
/// the least depth for a contrast of 0.3 prints with 0.15 to 0.19, less on curved surfaces. Codes whose modules all
/// keep two thirds decode as well as codes carved deeper all over (bench/printing/README.md).
inline constexpr double kPrintedShare = 2.0 / 3;

/// Returns the target contrast of each module of the design, so that its print is dark enough: raises the target by the
/// amount that the print falls short of kPrintedShare. No target decreases, because the design must decode, too.
///
/// A module's contrast is 1 − M/A, where M is its light through a verifier's aperture and A the light of its
/// surroundings (depth/light_neighbours.h). The print's contrast is compared with the design's mean contrast,
/// separately for finders and other modules, as their patterns differ.
///
/// @param designed, printed  light of the submodules of symbol and quiet zone, carved with the target `contrast`
///                           everywhere, 1 = unoccluded
/// @returns row-major from the symbol's top left, for FastSearchOptions::contrastOfModule
std::vector<double> contrastForPrint(const Symbol& symbol, const Grid<double>& designed, const Grid<double>& printed,
                                     double contrast);

}  // namespace qrelief
