// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace qrelief {

/// What a search for depths did, pass by pass, for whoever wants to watch it. Only what is carved changes between
/// passes; the lists of a pass are in the order of `carved`.
struct SearchRecord {
  struct Pass {
    std::vector<float> depthMm;    ///< the depths that were tried
    std::vector<float> luminance;  ///< the luminances that were seen at these depths
    double ms = 0;                 ///< rendering, reading back and solving
  };
  std::vector<std::uint32_t> carved;  ///< submodules, row-major from the symbol's top left, ascending
  std::vector<float> limitMm;         ///< greatest depth of each
  std::vector<Pass> passes;
  /// Of every submodule of symbol and quiet zone, as the last pass saw it; row-major from the quiet zone's top left.
  std::vector<float> luminance;
};

}  // namespace qrelief
