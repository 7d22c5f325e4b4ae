// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "depth/depth_solver.h"
#include "depth/light_neighbours.h"
#include "depth/pocket_sky.h"

namespace qrelief {

// Constants of the search. Those without lamps hold on the GPU, too (shader_search.h).
inline constexpr double kFirstDepthModules = 0.25;
inline constexpr double kChangeFraction = 0.4;  ///< of a floor's last change of difference: extra darkness to aim at
inline constexpr double kMaxChange = 0.3;       ///< limit on the change that counts
inline constexpr int kFreePasses = 3, kFreePassesAfterAnother = 1;
/// Under lamps, a pass makes a floor deeper by at most this, or by this fraction of its depth.
inline constexpr double kLampStepMm = 0.1, kLampGrowth = 0.1;
/// Under lamps, a floor that is still too bright after so many passes gets deeper by at least this in each.
inline constexpr int kLampPatience = 15;
inline constexpr double kLampLeastStepMm = 0.05;
/// Under lamps, a floor goes back if its last step made it deeper than necessary by more than this. Otherwise a small
/// difference in the light could change the depth by a whole step.
inline constexpr double kLampSlackMm = 0.02;
/// Greatest number of times that a floor goes back under lamps, and number of last passes in which none does.
inline constexpr int kLampReturns = 4, kLampLastPasses = 10;
/// Margin by which the search aims darker, as a fraction of the threshold, so that G ends at 0 or below.
inline constexpr double kAimFraction = 0.003;
inline constexpr double kMaxAimFraction = 0.2;

/// Returns the margin for floors that are too bright. It grows with the passes, because the few floors that stay too
/// bright are badly predicted by the plane.
inline double aimForTooBright(int iterations, int freePasses) {
  return std::min(kAimFraction * std::pow(3.0, std::max(0, iterations - freePasses + 1)), kMaxAimFraction);
}

/// Returns the first estimate of measured minus predicted darkness: interreflection.
inline double firstDifference(double albedo) {
  constexpr double kMaxAlbedo = 0.95;
  return std::log(1 - std::min(albedo, kMaxAlbedo));
}

struct FastSearchOptions {
  double contrast = 0.3;  ///< c: a carved submodule must be darker than its surroundings by this fraction, 0 … 1
  /// c per module, row-major from the symbol's top left; empty: `contrast` for all.
  std::vector<double> contrastOfModule = {};
  double slackMm = 0.05;  ///< tolerated excess depth of a submodule, approximate, > 0
  float albedo = 0.7f;    ///< albedo of the material, 0 … 1: first estimate of interreflection
  /// Lamps add to the sky: depths then start small and grow little by little. The plane's prediction knows the sky
  /// alone, and would jump to depths that the lamp's shadow does not need. A floor whose last step was longer than it
  /// needs goes back a part of that step (DepthBounds).
  bool hasLamps = false;
  int maxIterations = 24;
  int sweepsPerPass = 3;  ///< of the solver on the plane; more come closer to its solution
};

/// Returns the least growth of a floor that is too bright, mm.
inline double leastGrowthMm(const FastSearchOptions& options, int iterations) {
  return options.hasLamps && iterations >= kLampPatience ? kLampLeastStepMm : kDepthQuantumMm;
}

/// Depths between which a floor becomes dark enough under lamps, by linear interpolation of its luminance.
struct DepthBounds {
  double brightMm = 0, brightFraction = 1;  ///< where it was last too bright, and its LS/AL there
  double darkMm = 0, darkFraction = 0;      ///< a greater depth since then where it was dark enough; 0: none
  int returns = 0;                          ///< how often the floor went back, which ends the search

  bool isClosed() const { return darkMm > 0; }
  /// Takes a measurement. @param asked  greatest LS/AL
  void measured(double depthMm, double fraction, double asked);
  /// Returns the depth at which the floor should see `asked`, brightMm … darkMm. Call it if isClosed().
  double neededMm(double asked) const;
  /// Returns a depth to try next, well inside the bounds; darkMm if there are fewer than two depths between.
  double nextMm(double asked) const;
};

/// Reaches the same target as the paper's search (PaperStepSearch: no submodule with G = AL·(c − 1) + LS > 0) with less
/// rendering and no greater depths.
///
/// It solves for the depths on a plane without rendering (PocketSky), neighbours included. Each pass then measures how
/// much brighter or darker interreflection and curvature make a floor than the plane predicts. The next solution
/// applies this difference, taken in log((1 − V)/V), V = LS/AL, which depends little on the depth. Where the difference
/// has changed, the search aims darker. In the first passes depths may rise and fall. Afterwards a floor that is dark
/// enough gets deeper only if deeper neighbours brighten it, so the search ends. Each pass then measures only floors
/// that moved or that such a move may have brightened. At the end the search measures all floors once more. If a floor
/// then has to move, it measures the floors in sight of it again (PocketSky).
class FastSearch final : public DepthSolver {
 public:
  /// @param before  a search for the same target with other contrasts, whose result is the start; null: start from the
  ///                plane. With lamps, depths hardly shrink from there, so no contrast may be lower than before
  FastSearch(CarvingTarget target, const FastSearchOptions& options, const FastSearch* before = nullptr);

  void update(const Grid<double>& luminance) override;

  std::span<const std::uint32_t> due() const override { return dueInMask_; }

  bool finished() const override { return finished_; }
  int iterations() const override { return iterations_; }
  double doneFraction() const override;
  const DepthField& depths() const override { return depths_; }
  std::size_t limitedCount() const override;
  std::size_t unfinishedCount() const override;

 private:
  enum class State : std::uint8_t { TooBright, TooDeep, Done, Limited };

  void solve();
  std::size_t moduleOf(std::size_t k) const;
  std::vector<double> carvedDepths() const;
  double expectedFraction(std::size_t k, double planeFraction) const;
  void chooseDue(const std::vector<double>& depthsBefore);
  void markStale(const std::vector<double>& depthsBefore);
  void chooseStale();
  bool allAreDue() const { return dueInMask_.empty(); }
  bool mayReturn(int pass) const { return pass + kLampLastPasses < options_.maxIterations; }
  bool isTooDeepUnderLamps(std::size_t k, double depthMm) const;
  double aimedFraction(std::size_t k) const { return fractionAsked_[k] * (1 - kAimFraction); }

  CarvingTarget target_;
  FastSearchOptions options_;
  LightNeighbours neighbours_;
  std::shared_ptr<const PocketSky> sky_;
  DepthField depths_;
  // Per carved submodule, in the order of sky_->carved():
  std::vector<double> limitMm_, solvedMm_;
  std::vector<double> fractionAsked_;     // 1 − c: greatest LS/AL
  std::vector<double> difference_;        // measured minus predicted by the plane
  std::vector<double> differenceChange_;  // change of that at the last measurement
  std::vector<double> seenFraction_;      // LS/AL at the last measurement
  std::vector<DepthBounds> bounds_;       // under lamps
  std::vector<State> states_;
  std::vector<char> isDue_;
  std::vector<char> isStale_;             // something in its sight has moved since its last measurement
  std::vector<std::uint32_t> dueInMask_;  // none: all
  int iterations_ = 0;
  int freePasses_ = 0;  // after these passes no depth decreases, so the search ends
  bool allRemeasured_ = false;
  bool finished_ = false;
};

}  // namespace qrelief
