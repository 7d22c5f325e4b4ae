// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/grid.h"
#include "qr/module_pattern.h"

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

}  // namespace qrelief
