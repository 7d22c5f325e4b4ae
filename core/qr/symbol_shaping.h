// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "qr/symbol.h"

namespace qrelief {

/// The same text under another mask: data modules and format information are written anew [ISO/IEC 18004, 7.8, 7.9].
/// @param mask  0 … 7
Symbol withMask(const Symbol& symbol, int mask);

/// Under the mask whose dark data modules would see the least sky (qr/sky_fraction.h); of equals the first.
Symbol withShadiestMask(const Symbol& symbol);

/// Makes dark data modules light, those that see the most sky first, so that large dark areas break up [Peng 2019].
/// Readers restore them; what is spent of the error correction leaves each block as much as level L would give it.
/// Further modules of a codeword that is wrong already, and remainder bits, cost nothing.
///
/// Cost: O(flips · modules).
void breakUpDarkAreas(Symbol& symbol);

/// What breakUpDarkAreas has left of the error correction.
struct CorrectionReserve {
  int correctable = 0;     ///< wrong codewords that a reader restores in each block
  int spent = 0;           ///< on flipped modules, in the block that has most of them
  int flippedModules = 0;  ///< of the symbol
};

CorrectionReserve correctionReserve(const Symbol& symbol);

}  // namespace qrelief
