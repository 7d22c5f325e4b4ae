// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "depth/depth_solver.h"
#include "depth/light_neighbours.h"

namespace qrelief {

/// Returns the depth increase after x iterations without a significant change of luminance, mm [Papp 2022, §7]:
/// O(x) = c₀ − c₀·e·(tanh(1/d − f) + tanh(f − x/d)) with c₀ = 0.1, d = 2, e = 3, f = 2.5.
double depthIncrease(int x);

/// Luminance that a submodule's luminance is compared with to find x, the iterations without a significant change.
enum class ChangeSince : std::uint8_t {
  LastIteration,  ///< x is reset whenever one step changes the luminance significantly
  LastChange      ///< x is reset once the luminance differs significantly from its value at the last reset
};

struct DepthSearchOptions {
  double contrast = 0.3;  ///< c: a carved submodule must be darker than its surroundings by this fraction, 0 … 1
  Surroundings surroundings = Surroundings::LightModules;
  double initialDepthMm = 0.1;       ///< first depth of every carved submodule, > 0
  double significantChange = 0.005;  ///< a smaller change of luminance counts as "not changed"
  ChangeSince changeSince = ChangeSince::LastIteration;
  bool roundSteps = true;  ///< round every step up to kDepthQuantumMm; false: round only depths(), not their sum
  int maxIterations = 60;
};

/// Reason why a submodule is no deeper.
enum class DepthState : std::uint8_t { Light, Searching, DarkEnough, Limited };

/// The paper's iterative search [Papp 2022, §7].
///
/// It carves a submodule deeper while G = AL·(c − 1) + LS > 0. LS is the submodule's luminance, AL the mean of the four
/// darkest modules around its module (light_neighbours.h).
class PaperStepSearch final : public DepthSolver {
 public:
  PaperStepSearch(CarvingTarget target, const DepthSearchOptions& options);

  void update(const Grid<double>& luminance) override;

  bool finished() const override { return finished_; }
  int iterations() const override { return iterations_; }
  double doneFraction() const override;
  const DepthField& depths() const override { return depths_; }
  const std::vector<DepthState>& states() const { return states_; }
  std::size_t limitedCount() const override;
  std::size_t unfinishedCount() const override;
  /// Returns the greatest remaining G, 0 if none: the excess brightness of the worst submodule.
  double worstExcess() const { return worstExcess_; }

 private:
  CarvingTarget target_;
  DepthSearchOptions options_;
  LightNeighbours neighbours_;
  DepthField depths_;
  std::vector<DepthState> states_;
  std::vector<double> wantedMm_;  // depth per submodule before rounding
  std::vector<double> previous_;  // luminance to compare with, per submodule (ChangeSince)
  std::vector<int> unchanged_;    // iterations since it last changed significantly
  int iterations_ = 0;
  bool finished_ = false;
  double worstExcess_ = 0;
};

}  // namespace qrelief
