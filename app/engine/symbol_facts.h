// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace qrelief {

struct EngraveRequest;

/// Describes the symbol that a request engraves, as far as it is known before the symbol is placed. Returns a verb's
/// answer:
///
///     {"ok": true, "symbol": {"version", "ecc", "mask", "size", "rows": ["1011…", …], "bytes", "room",
///                             "leastModuleMm"}}
///
/// `rows` are the report's. `bytes` is the length of the text. `room` is the number of further bytes that the version
/// holds at the requested level, if they are neither digits nor capitals. `leastModuleMm` is the smallest module size
/// at which advisePrinting has no advice for the request's patterns and nozzle, to a hundredth of a millimetre.
///
/// Cost: milliseconds.
/// @param request  its text, symbol, patterns and nozzle count; if the nozzle has no valid size, leastModuleMm is null
/// @returns the error of encodeSymbol if there is no such symbol
std::string describeSymbol(const EngraveRequest& request);

}  // namespace qrelief
