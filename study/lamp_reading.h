// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "study/carved_code.h"
#include "study/spot.h"

namespace qrelief::study {

/// Tries that decode a carved code from the front under the sky and lamps, out of those of the verdict.
/// @param lights  empty: the sky alone
Result<int> readsUnder(const Spot& spot, const CarvedCode& code, const std::vector<DirectionalLight>& lights);

}  // namespace qrelief::study
