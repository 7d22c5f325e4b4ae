// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/grid.h"
#include "depth/depth_field.h"
#include "qr/module_pattern.h"
#include "qr/symbol.h"

namespace qrelief {

/// Input of a depth search.
struct CarvingTarget {
  const Symbol* symbol = nullptr;
  const SubmoduleMask* mask = nullptr;
  double symbolMm = 0;
  std::vector<double> limitMm;  ///< greatest depth of each submodule, row-major from the symbol's top left
};

/// A search for carving depths, pass by pass.
class DepthSearch {
 public:
  virtual ~DepthSearch() = default;

  virtual bool finished() const = 0;
  virtual int iterations() const = 0;
  /// Returns the fraction of carved submodules that are done; not monotone, because deeper neighbours brighten each
  /// other.
  virtual double doneFraction() const = 0;
  virtual const DepthField& depths() const = 0;
  /// Returns the number of submodules that are not dark enough: those at a limit and, once finished, unfinishedCount().
  virtual std::size_t limitedCount() const = 0;
  /// Returns the number of submodules that the end of a finished search left too bright, although they may be deeper.
  virtual std::size_t unfinishedCount() const = 0;
};

/// A search that does no rendering: it takes luminances and returns depths.
///
///     while (!solver.finished()) solver.update(luminances(solver.depths(), solver.due()));
class DepthSolver : public DepthSearch {
 public:
  /// Runs one pass.
  /// @param luminance  mean of every submodule of symbol and quiet zone at `depths()`, linear, 1 = unoccluded;
  ///                   edge = 5·(modules + 8)
  virtual void update(const Grid<double>& luminance) = 0;

  /// Returns the carved submodules whose luminance the next `update` reads, as indices in the mask; the luminance of
  /// the others may be outdated. Empty: all carved submodules.
  virtual std::span<const std::uint32_t> due() const { return {}; }
};

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
