// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/grid.h"
#include "qr/module_pattern.h"
#include "qr/symbol.h"

namespace qrelief {

/// Modules rendered beyond the quiet zone on each side, so that the quiet zone's own occlusion is complete.
inline constexpr int kOcclusionMarginModules = 1;

/// Returns the luminance of a submodule of the symbol.
/// @param luminance    of the submodules of symbol and quiet zone
/// @param row, column  from the symbol's top left
inline double luminanceOf(const Grid<double>& luminance, int row, int column) {
  return luminance.at(row + kQuietZoneSubmodules, column + kQuietZoneSubmodules);
}

/// Returns the means of the modules of symbol and quiet zone.
/// @param luminance  of their submodules
inline Grid<double> moduleMeans(const Grid<double>& luminance) {
  constexpr int kN = kSubmodulesPerModule;
  Grid<double> means(luminance.rows() / kN, luminance.columns() / kN);
  for (int row = 0; row < luminance.rows(); ++row)
    for (int column = 0; column < luminance.columns(); ++column)
      means.at(row / kN, column / kN) += luminance.at(row, column) / (kN * kN);
  return means;
}

/// Modules that count as a dark module's surroundings.
enum class Surroundings : std::uint8_t {
  /// The light modules, quiet zone included, of the 8-neighbourhood, widened ring by ring until it holds four. Carved
  /// neighbours do not count, because their depths would chase each other (docs/decisions/0053).
  LightModules,
  EightNeighbours  ///< all eight, dark or light: the paper's words
};

/// The surroundings of each dark module for comparing luminances [Papp 2022, §7: AL].
class LightNeighbours {
 public:
  explicit LightNeighbours(const Symbol& symbol, Surroundings surroundings = Surroundings::LightModules);

  /// Returns the mean luminance of the four darkest modules of a dark module's surroundings.
  /// @param module     row-major in the symbol
  /// @param luminance  of every module of symbol and quiet zone
  double darkestMean(std::size_t module, const Grid<double>& luminance) const;

 private:
  std::vector<std::vector<std::uint32_t>> around_;  // per dark module: its surroundings, indexed as `luminance`
};

}  // namespace qrelief
