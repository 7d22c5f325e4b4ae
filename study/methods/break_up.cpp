// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/break_up.h"

#include <algorithm>

#include "qr/codewords.h"
#include "qr/sky_fraction.h"

namespace qrelief::study {
namespace {

/// Returns the number of codewords of each block that may become wrong, so that the rest corrects as much as level L
/// would.
int sparedPerBlock(const BlockStructure& structure, int version) {
  const BlockStructure least = blockStructure(version, ErrorCorrection::L);
  const int reserve = (least.correctable() * least.blocks + structure.blocks - 1) / structure.blocks;
  return std::max(0, structure.correctable() - reserve);
}

}  // namespace

void breakUpDarkAreas(Symbol& symbol) {
  const CodewordLayout layout = layoutCodewords(symbol);
  const int spare = sparedPerBlock(layout.structure, symbol.version);
  std::vector<int> spent(static_cast<std::size_t>(layout.structure.blocks), 0);
  std::vector<char> isWrong(layout.blockOfCodeword.size(), 0);
  const auto mayFlip = [&](std::size_t module) {
    const int codeword = layout.codewordOfModule[module];
    if (!symbol.dark[module] || symbol.roles[module] != ModuleRole::Data) return false;
    return codeword < 0 || isWrong[static_cast<std::size_t>(codeword)] ||
           spent[static_cast<std::size_t>(layout.blockOfCodeword[static_cast<std::size_t>(codeword)])] < spare;
  };

  symbol.flipped = {symbol.size, symbol.size};
  SkyFraction sky(symbol);
  // A module that sees no more sky than an isolated one is worth nothing to its neighbours when flipped.
  const double alone = SkyFraction::ofModuleAlone();
  for (;;) {
    std::size_t brightest = symbol.dark.size();
    double most = alone;
    for (std::size_t i = 0; i < symbol.dark.size(); ++i) {
      const double fraction = sky.of(static_cast<int>(i) / symbol.size, static_cast<int>(i) % symbol.size);
      if (fraction > most && mayFlip(i)) brightest = i, most = fraction;
    }
    if (brightest == symbol.dark.size()) break;
    if (const int index = layout.codewordOfModule[brightest]; index >= 0) {
      const auto codeword = static_cast<std::size_t>(index);
      spent[static_cast<std::size_t>(layout.blockOfCodeword[codeword])] += isWrong[codeword] ? 0 : 1;
      isWrong[codeword] = 1;
    }
    symbol.dark[brightest] = 0;
    symbol.flipped[brightest] = 1;
    sky.update(symbol, static_cast<int>(brightest) / symbol.size, static_cast<int>(brightest) % symbol.size);
  }
}

CorrectionReserve correctionReserve(const Symbol& symbol) {
  const CodewordLayout layout = layoutCodewords(symbol);
  CorrectionReserve reserve{layout.structure.correctable(), 0, 0};
  std::vector<int> spent(static_cast<std::size_t>(layout.structure.blocks), 0);
  for (std::size_t i = 0; i < layout.isSpoilt.size(); ++i)
    spent[static_cast<std::size_t>(layout.blockOfCodeword[i])] += layout.isSpoilt[i];
  reserve.spent = *std::max_element(spent.begin(), spent.end());
  reserve.flippedModules = static_cast<int>(std::count(symbol.flipped.begin(), symbol.flipped.end(), 1));
  return reserve;
}

}  // namespace qrelief::study
