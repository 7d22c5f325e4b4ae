// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "qr/symbol.h"

namespace qrelief {

/// Returns the same text under another mask, with new data modules and format information [ISO/IEC 18004, 7.8, 7.9].
/// @param mask  0 … 7
Symbol withMask(const Symbol& symbol, int mask);

/// Returns the symbol under the mask whose dark data modules would see the least sky (qr/sky_fraction.h); the first of
/// equals.
Symbol withShadiestMask(const Symbol& symbol);

}  // namespace qrelief
