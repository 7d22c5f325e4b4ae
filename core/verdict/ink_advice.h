// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/message.h"
#include "carving/mark.h"
#include "printing/print_process.h"
#include "verification/ink.h"

namespace qrelief {

/// A code in colour, as far as its print depends on it.
struct InkedCode {
  Mark mark = Mark::Inlay;
  double moduleMm = 0;
  double depthMm = 0, opaqueDepthMm = 0;  ///< of an inlay: as made, and as needed; 0: unknown
  Printer printer;
};

/// Returns warnings about the colours; empty if there are none. Inverted codes, which some phones refuse, and
/// contrasts that a verifier grades D (ISO/IEC 15415).
std::vector<Message> adviseInk(const Ink& ink);

/// Returns warnings about printing; empty if there are none.
std::vector<Message> adviseInkPrinting(const InkedCode& code);

/// Returns the widest nozzle whose lines are no wider than a module, mm.
double nozzleForInk(double moduleMm, const Printer& printer);

}  // namespace qrelief
