// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/grid.h"

namespace qrelief {

/// Record of a depth search, pass by pass, for display. Only carved submodules change between passes; the lists of a
/// pass are in the order of `carved`.
struct SearchRecord {
  struct Pass {
    std::vector<float> depthMm;    ///< depths tried
    std::vector<float> luminance;  ///< luminances measured at these depths
    double ms = 0;                 ///< time for rendering, reading back and solving
  };
  std::vector<std::uint32_t> carved;  ///< submodules, row-major from the symbol's top left, ascending
  std::vector<float> limitMm;         ///< greatest depth of each
  std::vector<Pass> passes;
  Grid<float> luminance;  ///< of every submodule of symbol and quiet zone in the last pass
};

}  // namespace qrelief
