// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "qr/symbol.h"

namespace qrelief::study {

/// Optimises the symbol as in Peng 2019 (see self_shadow_2019.h): makes dark modules in wide dark areas light; decoders
/// restore them.
///
/// From the authors' own program (QR-Optimization, main.cpp, data_Opti.cpp, VisualArea.cpp): level H. Each block may
/// spend half of the check codewords that it has more than at level L. Areas are 4-connected dark modules; the area of
/// a module is the part of its area that is visible from the module's middle. Areas come in the order of their mean,
/// and modules in the order of their area, largest first. The program flips the first data module that may be flipped
/// and computes all areas anew, until no block has anything left to spend. Further modules of a codeword that is
/// already damaged cost nothing.
///
/// Our choices where the program says nothing: 720 rays measure the visible area; equal modules come in reading order;
/// blocks of different sizes have the same budget.
///
/// Our own method flips the module that sees the most sky instead (study/methods/break_up.h).
/// @param symbol  of any level; below H there may be nothing to spend
/// Cost: O(flips · modules · rays).
void flipModules2019(Symbol& symbol);

/// Returns the codewords that each block may spend: (check codewords − those of level L) / 2, divided by the blocks,
/// rounded down.
int flipBudget2019(const Symbol& symbol);

/// Returns the area in modules² that is visible from a dark module's middle within its 4-connected dark area.
double visibleArea2019(const Symbol& symbol, int row, int column);

}  // namespace qrelief::study
