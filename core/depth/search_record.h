// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

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
  /// Luminance of every submodule of symbol and quiet zone in the last pass; row-major from the quiet zone's top left.
  std::vector<float> luminance;
};

}  // namespace qrelief
