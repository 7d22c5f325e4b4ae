// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/message.h"

namespace qrelief {

struct Printer;

/// Describe how a mark faces in the printer, and how it is printed, for use within a sentence.
/// @param facingDeg  see PrintedView
Message facing(double facingDeg);
Message printing(const Printer& printer);

}  // namespace qrelief
