// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "carving/depth_solver.h"
#include "carving/light_neighbours.h"

namespace qrelief {

/// Depth increase after x iterations without a significant change of luminance, mm [Papp 2022, §7]:
/// O(x) = c₀ − c₀·e·(tanh(1/d − f) + tanh(f − x/d)) with c₀ = 0.1, d = 2, e = 3, f = 2.5.
double depthIncrease(int x);

struct DepthSearchOptions {
  double contrast = 0.3;  ///< c: a carved submodule must be darker than its surroundings by this fraction, 0 … 1
  double initialDepthMm = 0.1;       ///< every carved submodule begins with this depth, > 0
  double significantChange = 0.005;  ///< a submodule whose luminance changes by less in an iteration has "not changed"
  int maxIterations = 60;
};

/// Why a submodule is no deeper.
enum class DepthState : std::uint8_t { Light, Searching, DarkEnough, Limited };

/// The paper's iterative search [Papp 2022, §7].
///
/// A submodule is carved deeper while G = AL·(c − 1) + LS > 0, LS its luminance and AL the mean of its module's four
/// darkest light neighbours (light_neighbours.h).
class DepthSearch final : public DepthSolver {
 public:
  DepthSearch(CarvingTarget target, const DepthSearchOptions& options);

  void update(std::span<const double> luminance) override;

  bool finished() const override { return finished_; }
  int iterations() const override { return iterations_; }
  double doneFraction() const override;
  const DepthField& depths() const override { return depths_; }
  const std::vector<DepthState>& states() const { return states_; }
  std::size_t limitedCount() const override;
  /// Greatest G left over, 0 if none: how far from dark enough the worst submodule is.
  double worstExcess() const { return worstExcess_; }

 private:
  CarvingTarget target_;
  DepthSearchOptions options_;
  LightNeighbours neighbours_;
  DepthField depths_;
  std::vector<DepthState> states_;
  std::vector<double> previous_;  // luminance of the last iteration, per submodule
  std::vector<int> unchanged_;    // iterations since it last changed significantly
  int iterations_ = 0;
  bool finished_ = false;
  double worstExcess_ = 0;
};

}  // namespace qrelief
