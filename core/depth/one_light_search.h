// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "depth/depth_solver.h"
#include "depth/light_neighbours.h"
#include "light/directional_light.h"

namespace qrelief {

struct OneLightOptions {
  DirectionalLight lamp;  ///< lamp that lights the code, in addition to the sky
  double contrast = 0.3;  ///< c: a carved submodule must be darker than its surroundings by this fraction, 0 … 1
  int maxPasses = 60;
};

/// Returns the fraction of a floor that must lie in the lamp's shadow for its mean to be darker than the open surface
/// by `contrast`, assuming a full view of the sky and no reflection: c·(1 + L)/L, where L is the lamp's irradiance of
/// the surface.
/// @param irradiance  L, 1 = irradiance by the sky
/// @returns at most 1
double shadowFraction(double contrast, double irradiance);

/// Returns the depth of the deepest submodule of an isolated, fully carved module on a plane, in submodule widths:
/// shadowFraction · tan(elevation), for a lamp along the module's rows or columns.
double shadowDepth(double contrast, const DirectionalLight& lamp);

/// Search for the least depths at which a code decodes under one lamp, whose light casts shadows into the pockets.
/// Under an even sky such a shallow code does not decode reliably [Peng 2020].
///
/// **Closed form, on a plane.** A point at depth d lies in the shadow of an obstacle at distance t towards the lamp, at
/// depth d', if d > d' + t·tan e. Going away from the lamp, each submodule gets the least depth at which the required
/// fraction (shadowFraction) of its points lies in the shadow of the rim or of the steps found before it. An uncarved
/// submodule begins a new run. For a run of submodules that are h wide along the lamp's azimuth this is
///
///     lamp                       depth of the k-th: (k + 1)·f·h·tan e,
///        `-.  ¯¯¯¯|                                 a staircase with the slope f·tan e
///            `-.  |__
///                `|  |__
///                 |     |__      each step's shadow covers the fraction f of the next floor
///
/// No submodule can be shallower, because shallower submodules towards the lamp need less depth behind them.
/// Long runs get deep, or end at their limits and stay bright: a lamp on a diagonal of the modules crosses the bars of
/// the finder patterns, and meets the uncarved corners that most patterns leave in modules. [Peng 2020 breaks long
/// runs by making modules light.]
///
/// **Passes.** The first pass derives the lamp's elevation over each module's surroundings from their luminance, in
/// place of e. Each further pass measures. Where a carved submodule is brighter than (1 − c) times its surroundings,
/// because pockets reflect or rims bend away, its required fraction grows by a fifth. Once the fraction exceeds 1, the
/// submodule goes deeper than the shadow, in fifths of h·tan e. Fractions only grow, and so do the depths. A submodule
/// stops at its limit, or where the lamp does not reach its surroundings. So the search ends when all submodules are
/// dark enough or have stopped.
///
/// Cost: O(carved submodules · length of a shadow) per pass, plus rendering.
class OneLightSearch final : public DepthSolver {
 public:
  OneLightSearch(CarvingTarget target, const OneLightOptions& options);

  void update(const Grid<double>& luminance) override;

  bool finished() const override { return finished_; }
  int iterations() const override { return passes_; }
  double doneFraction() const override;
  const DepthField& depths() const override { return depths_; }
  std::size_t limitedCount() const override;
  std::size_t unfinishedCount() const override;

 private:
  enum class State : std::uint8_t { TooBright, Done, Limited };
  struct Floor {
    std::uint32_t submodule = 0;  // index in the mask
    std::size_t module = 0;
    double tangent = 0;   // of the lamp's elevation over its surroundings; 0: they are unlit
    double fraction = 0;  // required fraction in shadow; above 1: depth beyond the shadow
    State state = State::TooBright;
  };

  void takeElevation(Floor& floor, double irradiance) const;
  double depthFor(const Floor& floor) const;
  void solve();

  CarvingTarget target_;
  OneLightOptions options_;
  LightNeighbours neighbours_;
  Vec2 towardsLamp_;  // unit, columns to the right and rows downwards
  DepthField depths_;
  std::vector<Floor> floors_;  // in order of distance, from the lamp's side
  int passes_ = 0;
  bool finished_ = false;
};

}  // namespace qrelief
