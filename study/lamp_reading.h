// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "study/carved_code.h"
#include "study/spot.h"

namespace qrelief::study {

/// Counts the verdict's tries that decode a carved code from the front under the sky and lamps.
Result<int> readsUnder(const StudyPlacement& spot, const CarvedCode& code, const std::vector<DirectionalLight>& lights);

}  // namespace qrelief::study
