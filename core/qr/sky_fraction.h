// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/grid.h"
#include "qr/symbol.h"

namespace qrelief {

/// Openness of a symbol's dark areas, before anything is carved: the fraction of a uniform sky, cosine-weighted, that
/// the middle of each dark module would see if all dark modules were carved half a module deep. A smaller dark area
/// receives less light and can be shallower: "an isolated module gives higher contrast than one with dark neighbours"
/// [Peng 2019, who take the area that is visible in the plane instead].
///
/// In each of 32 directions a wall of height h at distance d leaves d²/(d² + h²) of the sky.
class SkyFraction {
 public:
  explicit SkyFraction(const Symbol& symbol);

  /// Returns the fraction for a dark module with light ones all round.
  static double ofModuleAlone();

  /// Returns the fraction for a module, 0 … 1; 1 for light modules.
  double of(int row, int column) const { return fractions_.at(row, column); }

  /// Returns the mean over the dark data modules; 0 if there are none.
  double mean(const Symbol& symbol) const;

  /// Updates the fractions after one module has become light. Cost: only modules that could see it are computed again.
  void update(const Symbol& symbol, int row, int column);

 private:
  Grid<double> fractions_;
};

}  // namespace qrelief
