// SPDX-License-Identifier: GPL-3.0-or-later
#include "qr/codewords.h"

#include <array>
#include <cassert>

namespace qrelief {
namespace {

constexpr std::size_t kVersions = 40;
constexpr int kVerticalTiming = 6;  // its column belongs to no pair

/// [ISO/IEC 18004, table 9], by level L, M, Q, H and version.
constexpr std::array<std::array<int, kVersions>, 4> kCheckCodewordsPerBlock = {{
    {7,  10, 15, 20, 26, 18, 20, 24, 30, 18, 20, 24, 26, 30, 22, 24, 28, 30, 28, 28,
     28, 28, 30, 30, 26, 28, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30},
    {10, 16, 26, 18, 24, 16, 18, 22, 22, 26, 30, 22, 22, 24, 24, 28, 28, 26, 26, 26,
     26, 28, 28, 28, 28, 28, 28, 28, 28, 28, 28, 28, 28, 28, 28, 28, 28, 28, 28, 28},
    {13, 22, 18, 26, 18, 24, 18, 22, 20, 24, 28, 26, 24, 20, 30, 24, 28, 28, 26, 30,
     28, 30, 30, 30, 30, 28, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30},
    {17, 28, 22, 16, 22, 28, 26, 26, 24, 28, 24, 28, 22, 24, 24, 30, 28, 28, 26, 28,
     30, 24, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30},
}};
constexpr std::array<std::array<int, kVersions>, 4> kBlocks = {{
    {1, 1, 1, 1,  1,  2,  2,  2,  2,  4,  4,  4,  4,  4,  6,  6,  6,  6,  7,  8,
     8, 9, 9, 10, 12, 12, 12, 13, 14, 15, 16, 17, 18, 19, 19, 20, 21, 22, 24, 25},
    {1,  1,  1,  2,  2,  4,  4,  4,  5,  5,  5,  8,  9,  9,  10, 10, 11, 13, 14, 16,
     17, 17, 18, 20, 21, 23, 25, 26, 28, 29, 31, 33, 35, 37, 38, 40, 43, 45, 47, 49},
    {1,  1,  2,  2,  4,  4,  6,  6,  8,  8,  8,  10, 12, 16, 12, 17, 16, 18, 21, 20,
     23, 23, 25, 27, 29, 34, 34, 35, 38, 40, 43, 45, 48, 51, 53, 56, 59, 62, 65, 68},
    {1,  1,  2,  4,  4,  4,  5,  6,  8,  8,  11, 11, 16, 16, 18, 16, 19, 21, 25, 25,
     25, 34, 30, 32, 35, 37, 40, 42, 45, 48, 51, 54, 57, 60, 63, 66, 70, 74, 77, 81},
}};
/// p of [table 9]: versions 1 to 3.
constexpr std::array<std::array<int, 3>, 4> kMisdecodeReserve = {{{3, 2, 1}, {2, 0, 0}, {1, 0, 0}, {1, 0, 0}}};

/// Returns the number of modules outside the function patterns, format and version information.
int dataModules(int version) {
  int count = (16 * version + 128) * version + 64;
  if (version >= 2) {
    const int alignment = version / 7 + 2;
    count -= (25 * alignment - 10) * alignment - 55;
    if (version >= 7) count -= 36;
  }
  return count;
}

/// Returns the data modules in the order in which they are filled: pairs of columns from the right, alternately upwards
/// and downwards.
std::vector<int> dataModulesInOrder(const Symbol& symbol) {
  std::vector<int> order;
  bool upwards = true;
  for (int right = symbol.size - 1; right > 0; right -= 2, upwards = !upwards) {
    if (right == kVerticalTiming) --right;
    for (int step = 0; step < symbol.size; ++step) {
      const int row = upwards ? symbol.size - 1 - step : step;
      for (const int column : {right, right - 1})
        if (symbol.role(row, column) == ModuleRole::Data) order.push_back(row * symbol.size + column);
    }
  }
  return order;
}

}  // namespace

bool invertsModule(int mask, int row, int column) {
  switch (mask) {
    case 0:
      return (row + column) % 2 == 0;
    case 1:
      return row % 2 == 0;
    case 2:
      return column % 3 == 0;
    case 3:
      return (row + column) % 3 == 0;
    case 4:
      return (row / 2 + column / 3) % 2 == 0;
    case 5:
      return row * column % 2 + row * column % 3 == 0;
    case 6:
      return (row * column % 2 + row * column % 3) % 2 == 0;
    default:
      return ((row + column) % 2 + row * column % 3) % 2 == 0;
  }
}

BlockStructure blockStructure(int version, ErrorCorrection level) {
  assert(version >= 1 && version <= static_cast<int>(kVersions));
  const auto v = static_cast<std::size_t>(version - 1);
  const auto l = static_cast<std::size_t>(level);
  return {dataModules(version) / 8, kBlocks[l][v], kCheckCodewordsPerBlock[l][v],
          version <= 3 ? kMisdecodeReserve[l][v] : 0};
}

CodewordLayout layoutCodewords(const Symbol& symbol) {
  CodewordLayout layout;
  layout.structure = blockStructure(symbol.version, symbol.errorCorrection);
  const BlockStructure& s = layout.structure;
  layout.codewordOfModule.assign(symbol.dark.size(), -1);
  layout.isSpoilt.assign(static_cast<std::size_t>(s.codewords), 0);
  int bit = 0;
  for (const int module : dataModulesInOrder(symbol)) {
    const int codeword = bit++ / 8;
    if (codeword >= s.codewords) break;  // remainder bits
    const auto i = static_cast<std::size_t>(module);
    layout.codewordOfModule[i] = codeword;
    if (!symbol.flipped.empty() && symbol.flipped[i]) layout.isSpoilt[codeword] = 1;
  }
  // Data codewords go to the blocks in turn, skipping blocks that are full; the check codewords follow.
  const int longest = s.codewordsOfBlock(s.blocks - 1) - s.checkCodewords;
  for (int i = 0; i < longest; ++i)
    for (int block = 0; block < s.blocks; ++block)
      if (i < s.codewordsOfBlock(block) - s.checkCodewords) layout.blockOfCodeword.push_back(block);
  for (int i = 0; i < s.checkCodewords; ++i)
    for (int block = 0; block < s.blocks; ++block) layout.blockOfCodeword.push_back(block);
  return layout;
}

std::vector<std::vector<std::uint8_t>> readBlocks(const Symbol& symbol, const CodewordLayout& layout) {
  std::vector<std::uint8_t> codewords(static_cast<std::size_t>(layout.structure.codewords), 0);
  for (const int module : dataModulesInOrder(symbol)) {
    const int codeword = layout.codewordOfModule[module];
    if (codeword < 0) continue;
    const int row = module / symbol.size, column = module % symbol.size;
    const bool bit = symbol.isDark(row, column) != invertsModule(symbol.mask, row, column);
    auto& value = codewords[codeword];
    value = static_cast<std::uint8_t>(value << 1 | static_cast<int>(bit));
  }
  std::vector<std::vector<std::uint8_t>> blocks(static_cast<std::size_t>(layout.structure.blocks));
  for (std::size_t i = 0; i < codewords.size(); ++i) blocks[layout.blockOfCodeword[i]].push_back(codewords[i]);
  return blocks;
}

}  // namespace qrelief
