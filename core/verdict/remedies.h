// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "verdict/verdict.h"

namespace qrelief {

/// Against a code that does not read, or barely: more depth, a larger code, more error correction, another place.
std::vector<Remedy> readingRemedies(const EngraveRequest& request, const EngraveResult& result);

/// Against one that may not print: a larger code, another pattern, a finer nozzle, more depth, thinner layers, another
/// place. Nozzles and layers are the largest that are sold and would do.
std::vector<Remedy> printingRemedies(const EngraveRequest& request, const EngraveResult& result);

/// Another place for the code.
Remedy anotherSpot();

}  // namespace qrelief
