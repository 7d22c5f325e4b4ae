// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "verdict/engraving.h"

namespace qrelief {

/// Engraves a code with all checks: decodes with ZXing, and simulates prints on other cores. Carves as requested or,
/// where that does not decode well, with changed settings: see EngravePlan.
/// @param tell     is called with the progress of each attempt
/// @param options  simulating prints, the default, takes two fifths of the time
/// @returns the errors of Engraving::advance()
Result<Engraved> engrave(
    Engraver& engraver, const EngraveRequest& request, const EngravePlan::Options& options = {},
    const std::function<void(const Progress&)>& tell = [](const Progress&) {});

}  // namespace qrelief
