// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "qr/symbol.h"

namespace qrelief::study {

/// The symbol optimisation of Peng 2019 (see self_shadow_2019.h): dark modules in wide dark areas are made light, and
/// readers restore them.
///
/// From the authors' own program (QR-Optimization, main.cpp, data_Opti.cpp, VisualArea.cpp): level H; each block may
/// spend half of what its check codewords have more than those of level L; areas are 4-connected dark modules, the area
/// of a module is what is seen within it from the module's middle. Areas are taken in the order of their mean, modules
/// in theirs, largest first; the first data module that may be flipped is flipped, all is computed anew, until no block
/// has anything left. Further modules of a codeword that is spoilt already cost nothing.
///
/// Chosen where it is silent: what is seen is measured by 720 rays; equal ones go in reading order; where blocks differ
/// in size their budget is the same.
///
/// Ours flips the module that sees the most sky instead (qr/symbol_shaping.h).
/// @param symbol  of any level; below H there may be nothing to spend
/// Cost: O(flips · modules · rays).
void flipModules2019(Symbol& symbol);

/// Codewords that each block may spend: (check codewords − those of level L) / 2, over the blocks, rounded down.
int flipBudget2019(const Symbol& symbol);

/// Area in modules² of what is seen within its 4-connected dark area from a dark module's middle.
double visibleArea2019(const Symbol& symbol, int row, int column);

}  // namespace qrelief::study
