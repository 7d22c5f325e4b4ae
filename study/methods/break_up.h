// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "qr/symbol.h"

namespace qrelief::study {

/// Makes dark data modules light, starting with those that see the most sky, to break up large dark areas [Peng 2019].
/// Decoders restore them. Each block keeps as much error correction as level L would give it. Further modules of a
/// codeword that is already wrong, and remainder bits, cost nothing. It was the setting `breakUp`. Codes get
/// a little shallower and decode less often (docs/decisions/0042).
///
/// Cost: O(flips · modules).
void breakUpDarkAreas(Symbol& symbol);

/// Error correction that remains after modules were flipped on purpose (Symbol::flipped).
struct CorrectionReserve {
  int correctable = 0;     ///< wrong codewords that a decoder can restore in each block
  int spent = 0;           ///< codewords spent on flipped modules, in the block with the most
  int flippedModules = 0;  ///< in the whole symbol
};

CorrectionReserve correctionReserve(const Symbol& symbol);

}  // namespace qrelief::study
