// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "base/result.h"
#include "carving/depth_field.h"
#include "qr/module_pattern.h"
#include "qr/symbol.h"

namespace qrelief {

/// Depth increase after x iterations without a significant change of luminance, mm [Papp 2022, §7]:
/// O(x) = c₀ − c₀·e·(tanh(1/d − f) + tanh(f − x/d)) with c₀ = 0.1, d = 2, e = 3, f = 2.5.
double depthIncrease(int x);

struct DepthSearchOptions {
  double contrast = 0.3;        ///< c: a carved submodule must be darker than its surroundings by this share, 0 … 1
  double initialDepthMm = 0.1;  ///< of every carved submodule, > 0
  double significantChange = 0.005;  ///< of a submodule's luminance between iterations; less is "not changed"
  int maxIterations = 60;
};

/// What the search works on.
struct CarvingTarget {
  const Symbol* symbol = nullptr;
  const SubmoduleMask* mask = nullptr;
  double symbolMm = 0;
  std::vector<double> limitMm;  ///< greatest depth of each submodule, row-major from the symbol's top left
};

/// Why a submodule is no deeper.
enum class DepthState : std::uint8_t { Light, Searching, DarkEnough, Limited };

/// The paper's iterative search [Papp 2022, §7], without the rendering: it is told luminances and answers depths.
///
/// A submodule is carved deeper while G = AL·(c − 1) + LS > 0, LS its luminance and AL the mean of its module's four
/// darkest light neighbours. The paper says "neighbours"; meant are the light modules (quiet zone included), in the
/// 8-neighbourhood widened ring by ring until it holds four: carved neighbours would chase each other.
///
///     while (!search.finished()) search.update(luminances(search.depths()));
class DepthSearch {
 public:
  DepthSearch(CarvingTarget target, const DepthSearchOptions& options);

  /// One iteration.
  /// @param luminance  mean of every submodule of symbol and quiet zone, linear, 1 = unoccluded; row-major from the
  ///                   quiet zone's top left, edge = 5·(modules + 8)
  void update(std::span<const double> luminance);

  bool finished() const { return finished_; }
  int iterations() const { return iterations_; }
  /// Share of the carved submodules that are done; not monotone, as deeper neighbours brighten each other.
  double doneShare() const;
  const DepthField& depths() const { return depths_; }
  const std::vector<DepthState>& states() const { return states_; }
  std::size_t limitedCount() const;
  /// Greatest G left over, 0 if none: how far from dark enough the worst submodule is.
  double worstExcess() const { return worstExcess_; }

 private:
  void findNeighbours();
  double surroundings(std::size_t module, std::span<const double> moduleLuminance) const;

  CarvingTarget target_;
  DepthSearchOptions options_;
  DepthField depths_;
  std::vector<DepthState> states_;
  std::vector<double> previous_;                        // luminance of the last iteration, per submodule
  std::vector<int> unchanged_;                          // iterations since it last changed significantly
  std::vector<std::vector<std::uint32_t>> neighbours_;  // per module: light modules around it, quiet zone indexing
  int iterations_ = 0;
  bool finished_ = false;
  double worstExcess_ = 0;
};

}  // namespace qrelief
