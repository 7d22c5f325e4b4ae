// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <span>
#include <vector>

#include "qr/module_pattern.h"
#include "qr/symbol.h"

namespace qrelief {

/// Modules rendered beyond the quiet zone on each side, so that the quiet zone's own occlusion is complete.
inline constexpr int kOcclusionMarginModules = 1;

/// Input luminances of a DepthSolver: one for every submodule of symbol and quiet zone, row-major from the quiet zone's
/// top left.
class SubmoduleLuminances {
 public:
  /// @param luminance  kept by reference
  /// @param modules    of the symbol along its edge
  SubmoduleLuminances(std::span<const double> luminance, int modules) : luminance_(luminance), modules_(modules) {
    assert(luminance.size() == static_cast<std::size_t>(edge() * edge()));
  }

  /// Returns the number of submodules along the edge of symbol and quiet zone.
  int edge() const { return kSubmodulesPerModule * withQuiet(); }

  /// @param row, column  submodules from the symbol's top left
  double of(int row, int column) const {
    constexpr int kQuiet = kSubmodulesPerModule * kQuietZoneModules;
    return luminance_[static_cast<std::size_t>((row + kQuiet) * edge() + column + kQuiet)];
  }

  /// Returns the means of the modules of symbol and quiet zone, row-major from the quiet zone's top left.
  std::vector<double> moduleMeans() const {
    constexpr int kN = kSubmodulesPerModule;
    std::vector<double> means(static_cast<std::size_t>(withQuiet() * withQuiet()), 0);
    for (int row = 0; row < edge(); ++row)
      for (int column = 0; column < edge(); ++column)
        means[static_cast<std::size_t>(row / kN * withQuiet() + column / kN)] +=
            luminance_[static_cast<std::size_t>(row * edge() + column)] / (kN * kN);
    return means;
  }

 private:
  int withQuiet() const { return modules_ + 2 * kQuietZoneModules; }

  std::span<const double> luminance_;
  int modules_;
};

}  // namespace qrelief
