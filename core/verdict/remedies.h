// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "verdict/verdict.h"

namespace qrelief {

/// Returns remedies for a code that does not read, or barely does: the other colours, more depth, a larger code, more
/// error correction, another place.
std::vector<Remedy> readingRemedies(const EngraveRequest& request, const EngraveResult& result);

/// Returns remedies for a code that may not print: a larger code, another pattern, a finer nozzle, more depth, thinner
/// layers, another place. Suggests the largest nozzles and layers on the market that suffice.
/// @param wasPrinted  true: the simulated print did not read well. Then more depth comes first: with it, 20 of 25 such
///                    prints read at least barely (bench/printing)
std::vector<Remedy> printingRemedies(const EngraveRequest& request, const EngraveResult& result, bool wasPrinted);

/// Returns remedies for a text alone whose letters are too small: a larger text, a finer nozzle, another place.
/// @param growth      factor by which the letters must grow, > 1
/// @param isForPrint  a finer nozzle helps, too
std::vector<Remedy> textRemedies(const EngraveRequest& request, const EngraveResult& result, double growth,
                                 bool isForPrint);

/// Returns the remedy "choose another spot".
Remedy anotherSpot();

}  // namespace qrelief
