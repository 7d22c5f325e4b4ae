// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "verdict/verdict.h"

namespace qrelief {

/// Against a code that does not read, or barely: more depth, a larger code, more error correction, another place.
std::vector<Remedy> readingRemedies(const EngraveRequest& request, const EngraveResult& result);

/// Against one that may not print: a larger code, another pattern, a finer nozzle, more depth, thinner layers, another
/// place. Nozzles and layers are the largest that are sold and would do.
/// @param wasPrinted  in simulation, and did not read well: then more depth comes first, with which 20 of 25 such
///                    prints read at least barely (bench/printing)
std::vector<Remedy> printingRemedies(const EngraveRequest& request, const EngraveResult& result, bool wasPrinted);

/// Another place for the code.
Remedy anotherSpot();

}  // namespace qrelief
