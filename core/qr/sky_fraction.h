// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "qr/symbol.h"

namespace qrelief {

/// How open the dark areas of a symbol are, before anything is carved: the fraction of a uniform sky that the middle of
/// each dark module would see, cosine-weighted, were all dark modules carved half a module deep. The smaller a dark
/// area, the less light falls into it, and the less deep it has to be: "an isolated module gives higher contrast than
/// one with dark neighbours" [Peng 2019, who take the area that is visible in the plane instead].
///
/// In each of 32 directions a wall of height h at distance d leaves d²/(d² + h²) of the sky.
class SkyFraction {
 public:
  explicit SkyFraction(const Symbol& symbol);

  /// Of a dark module with light ones all round.
  static double ofModuleAlone();

  /// 0 … 1; 1 for light modules.
  double of(int row, int column) const { return fractions_[static_cast<std::size_t>(row * size_ + column)]; }

  /// Mean over the dark data modules; 0 if there are none.
  double mean(const Symbol& symbol) const;

  /// After one module has become light. Cost: that of the modules that could see it.
  void update(const Symbol& symbol, int row, int column);

 private:
  int size_;
  std::vector<double> fractions_;
};

}  // namespace qrelief
