// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "carving/depth_solver.h"
#include "carving/light_neighbours.h"
#include "carving/pocket_sky.h"

namespace qrelief {

struct FastSearchOptions {
  double contrast = 0.3;  ///< c: a carved submodule must be darker than its surroundings by this fraction, 0 … 1
  /// c of each module, row-major from the symbol's top left, where modules differ; empty: that above for all.
  std::vector<double> contrastOfModule = {};
  double slackMm = 0.05;  ///< a submodule is no deeper than it must be by more than about this, > 0
  double albedo = 0.7;    ///< of the material, 0 … 1: what interreflection is expected to be at first
  int maxIterations = 24;
};

/// Reaches what the paper's search reaches (DepthSearch: no submodule with G = AL·(c − 1) + LS > 0) with less to render
/// and no deeper.
///
/// The depths are solved for on a plane without rendering (PocketSky), neighbours and all. What a pass then shows to be
/// brighter or darker than the plane said, by interreflection and curvature, is carried over to the next solution: as a
/// difference in log((1 − V)/V), V = LS/AL, which depends little on the depth; where it did change, more darkness is
/// aimed at. At first depths rise and fall; then what is dark enough only gets deeper where deeper neighbours brighten
/// it, so that the search ends, and only what moved and what that may have brightened is measured. Before it ends all
/// are measured once more, and then again those that see what had to move, as far as the plane tells.
class FastSearch final : public DepthSolver {
 public:
  /// @param before  of the same target, with another contrast: it begins at what that found; null: at what a plane says
  FastSearch(CarvingTarget target, const FastSearchOptions& options, const FastSearch* before = nullptr);

  void update(std::span<const double> luminance) override;

  std::span<const std::uint32_t> due() const override { return dueInMask_; }

  bool finished() const override { return finished_; }
  int iterations() const override { return iterations_; }
  double doneFraction() const override;
  const DepthField& depths() const override { return depths_; }
  std::size_t limitedCount() const override;

 private:
  enum class State : std::uint8_t { TooBright, TooDeep, Done, Limited };

  void solve();
  std::vector<double> carvedDepths() const;
  double expectedFraction(std::size_t k, double planeFraction) const;
  void chooseDue(const std::vector<double>& depthsBefore);
  void markStale(const std::vector<double>& depthsBefore);
  void chooseStale();
  bool allAreDue() const { return dueInMask_.empty(); }

  CarvingTarget target_;
  FastSearchOptions options_;
  LightNeighbours neighbours_;
  std::shared_ptr<const PocketSky> sky_;
  DepthField depths_;
  // Per carved submodule, in the order of sky_->carved():
  std::vector<double> limitMm_, solvedMm_;
  std::vector<double> fractionAsked_;     // 1 − c: greatest LS/AL
  std::vector<double> difference_;        // between what was seen and what the plane says
  std::vector<double> differenceChange_;  // by how much that changed when it was last measured
  std::vector<double> seenFraction_;      // LS/AL when it was last measured
  std::vector<State> states_;
  std::vector<char> isDue_;
  std::vector<char> isStale_;             // something it sees has moved since it was measured
  std::vector<std::uint32_t> dueInMask_;  // none: all
  int iterations_ = 0;
  int freePasses_ = 0;  // after these nothing becomes less deep: that ends
  bool allRemeasured_ = false;
  bool finished_ = false;
};

}  // namespace qrelief
