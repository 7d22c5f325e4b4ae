// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "pipeline/engrave.h"

namespace qrelief {

/// The symbol that a request engraves, and what can be said of it before it has a place; as a verb's answer:
///
///     {"ok": true, "symbol": {"version", "ecc", "mask", "size", "rows": ["1011…", …], "bytes", "room",
///                             "leastModuleMm"}}
///
/// `rows` are those of the report. `bytes` is the text's length, `room` how many bytes more the version holds at the
/// level asked for, if they are neither digits nor capitals. `leastModuleMm` is the smallest module that
/// advisePrinting has nothing to say about, for the request's patterns and nozzle, to a hundredth of a millimetre.
///
/// Cost: milliseconds.
/// @param request  its text, symbol, patterns and nozzle count; a nozzle that is no size leaves leastModuleMm null
/// @returns the error of encodeSymbol if there is no such symbol
std::string describeSymbol(const EngraveRequest& request);

}  // namespace qrelief
