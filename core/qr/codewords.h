// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "qr/symbol.h"

namespace qrelief {

/// Error correction of one symbol. Every block has the same number of check codewords; the later blocks may have one
/// more data codeword [ISO/IEC 18004, table 9].
struct BlockStructure {
  int codewords = 0;         ///< total of the symbol
  int blocks = 0;            ///< Reed-Solomon blocks
  int checkCodewords = 0;    ///< per block
  int misdecodeReserve = 0;  ///< check codewords kept against misdecoding, p: 0 … 3, only in versions 1 to 3

  int shortBlocks() const { return blocks - codewords % blocks; }
  int codewordsOfBlock(int block) const { return codewords / blocks + (block >= shortBlocks()); }
  /// Returns the number of wrong codewords that a block can correct, (check − p) / 2.
  int correctable() const { return (checkCodewords - misdecodeReserve) / 2; }
};

/// @param version  1 … 40
BlockStructure blockStructure(int version, ErrorCorrection level);

/// Returns true if a mask inverts the data module there [ISO/IEC 18004, table 10].
/// @param mask  0 … 7
bool invertsModule(int mask, int row, int column);

/// The codeword of each module and the block of each codeword [ISO/IEC 18004, 7.6 and 7.7.3].
struct CodewordLayout {
  BlockStructure structure;
  std::vector<int> codewordOfModule;  ///< row-major; -1: no codeword (function patterns, remainder bits)
  std::vector<int> blockOfCodeword;
  std::vector<std::uint8_t> isSpoilt;  ///< for each codeword: 1 = one of its modules was flipped on purpose
};

/// Cost: O(modules).
CodewordLayout layoutCodewords(const Symbol& symbol);

/// Returns the codewords of each block in order, data first, without the symbol's mask.
std::vector<std::vector<std::uint8_t>> readBlocks(const Symbol& symbol, const CodewordLayout& layout);

}  // namespace qrelief
