// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "verdict/engraving.h"

namespace qrelief {

/// Engraves a code with all checks: decodes with ZXing, and simulates prints on other cores. Carves as requested or,
/// where that does not decode well, with changed settings: see EngravePlan.
/// @param options        simulating prints, the default, takes two fifths of the time
/// @param tell           is called with the progress of each attempt
/// @param whilePrinting  is called with a carving whose print is being simulated, before the result is known: a time to
///                       write its file (encodeCarved()), which is the one to deliver unless the print fails
/// @returns the errors of Engraving::advance()
Result<Engraved> engrave(
    Engraver& engraver, const EngraveRequest& request, const EngravePlan::Options& options = {},
    const std::function<void(const Progress&)>& tell = [](const Progress&) {},
    const std::function<void(const Engraved&)>& whilePrinting = [](const Engraved&) {});

}  // namespace qrelief
