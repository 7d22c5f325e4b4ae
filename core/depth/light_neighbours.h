// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/grid.h"
#include "qr/symbol.h"

namespace qrelief {

/// The surroundings of each dark module for comparing luminances [Papp 2022, §7: AL]. The paper says "neighbours". Here
/// these are the light modules (quiet zone included) in the 8-neighbourhood, widened ring by ring until it holds four.
/// Carved neighbours do not count, because their depths would chase each other.
class LightNeighbours {
 public:
  explicit LightNeighbours(const Symbol& symbol);

  /// Returns the mean luminance of the four darkest light modules around a dark one.
  /// @param module     row-major in the symbol
  /// @param luminance  of every module of symbol and quiet zone
  double darkestMean(std::size_t module, const Grid<double>& luminance) const;

 private:
  std::vector<std::vector<std::uint32_t>> around_;  // per dark module: light modules, indexed as `luminance`
};

}  // namespace qrelief
