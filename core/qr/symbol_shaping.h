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

/// Makes dark data modules light, starting with those that see the most sky, to break up large dark areas [Peng 2019].
/// Decoders restore them. Each block keeps as much error correction as level L would give it. Further modules of a
/// codeword that is already wrong, and remainder bits, cost nothing.
///
/// Cost: O(flips · modules).
void breakUpDarkAreas(Symbol& symbol);

/// Error correction that remains after breakUpDarkAreas().
struct CorrectionReserve {
  int correctable = 0;     ///< wrong codewords that a decoder can restore in each block
  int spent = 0;           ///< codewords spent on flipped modules, in the block with the most
  int flippedModules = 0;  ///< in the whole symbol
};

CorrectionReserve correctionReserve(const Symbol& symbol);

}  // namespace qrelief
