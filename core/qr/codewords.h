// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "qr/symbol.h"

namespace qrelief {

/// Error correction of one symbol: every block has as many check codewords, the later blocks may have one data codeword
/// more [ISO/IEC 18004, table 9].
struct BlockStructure {
  int codewords = 0;         ///< of the symbol
  int blocks = 0;            ///< Reed-Solomon blocks
  int checkCodewords = 0;    ///< of each block
  int misdecodeReserve = 0;  ///< check codewords kept against misdecoding, p: 0 … 3, only in versions 1 to 3

  int shortBlocks() const { return blocks - codewords % blocks; }
  int codewordsOfBlock(int block) const { return codewords / blocks + (block >= shortBlocks()); }
  /// Wrong codewords that a block can correct, (check − p) / 2.
  int correctable() const { return (checkCodewords - misdecodeReserve) / 2; }
};

/// @param version  1 … 40
BlockStructure blockStructure(int version, ErrorCorrection level);

/// Whether a mask inverts the data module there [ISO/IEC 18004, table 10]. @param mask  0 … 7
bool invertsModule(int mask, int row, int column);

/// Which modules make up which codeword, and which codewords which block [ISO/IEC 18004, 7.6 and 7.7.3].
struct CodewordLayout {
  BlockStructure structure;
  std::vector<int> codewordOfModule;  ///< row-major; -1: no codeword (function patterns, remainder bits)
  std::vector<int> blockOfCodeword;
  std::vector<std::uint8_t> isSpoilt;  ///< for each codeword: 1 = it holds a module that was flipped on purpose
};

/// Cost: O(modules).
CodewordLayout layoutCodewords(const Symbol& symbol);

/// The codewords of each block in the order of their block, data first, with the symbol's mask taken off.
std::vector<std::vector<std::uint8_t>> readBlocks(const Symbol& symbol, const CodewordLayout& layout);

}  // namespace qrelief
