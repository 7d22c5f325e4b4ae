// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "carving/depth_solver.h"
#include "carving/light_neighbours.h"
#include "light/directional_light.h"

namespace qrelief {

struct OneLightOptions {
  DirectionalLight lamp;  ///< under which the code is to be read, beside the sky
  double contrast = 0.3;  ///< c: a carved submodule must be darker than its surroundings by this fraction, 0 … 1
  int maxPasses = 60;
};

/// Fraction of a floor that must lie in the lamp's shadow for its mean to be darker than the open surface by
/// `contrast`, were the sky seen whole and nothing reflected: c·(1 + L)/L, L the lamp's irradiance of the surface.
/// @param irradiance  L, 1 = that of the sky
/// @returns at most 1
double shadowFraction(double contrast, double irradiance);

/// Depth, in widths of it, of the deepest submodule of a lone module that is carved as a whole, on a plane:
/// shadowFraction · tan(elevation), for a lamp along the module's rows or columns.
double shadowDepth(double contrast, const DirectionalLight& lamp);

/// The least depths with which a code is read under one lamp, by the shadows that it casts into the pockets; under an
/// even sky so shallow a one is not read reliably [Peng 2020].
///
/// **Closed form, on a plane.** A point at depth d lies in the shadow of what stands at distance t towards the lamp, at
/// depth d', if d > d' + t·tan e. So from the lamp's side on each submodule has the least depth with which the fraction
/// asked (shadowFraction) of its points lies in the shadow of the rim, or of the steps down that were found before it.
/// What a pattern leaves standing begins a new run. Of a run of submodules h wide along the lamp's azimuth that is
///
///     lamp                       depth of the k-th: (k + 1)·f·h·tan e,
///        `-.  ¯¯¯¯|                                 a staircase with the slope f·tan e
///            `-.  |__
///                `|  |__
///                 |     |__      each step's shadow reaches over the fraction f of the next floor
///
/// the least in every place, as what is less deep towards the lamp asks for less behind it. Long runs get deep, or end
/// at their limits and stay bright: a lamp on a diagonal of the modules crosses the bars of the finder patterns, and
/// meets what most patterns leave standing in the modules' corners. [Peng 2020 breaks long runs by making modules
/// light.]
///
/// **Passes.** The first takes from the luminance of each module's surroundings how steeply the lamp stands over them,
/// in place of e. Each further one measures: where a carved submodule is brighter than (1 − c) of its surroundings, by
/// what pockets reflect, by rims that bend away, the fraction asked of it grows by a fifth; beyond 1, in fifths of
/// h·tan e, it is carved deeper than the shadow. Fractions only grow, and so do the depths; a submodule stops at its
/// limit, and where the lamp does not reach its surroundings. So the search ends, when all are dark enough or have
/// stopped.
///
/// Cost: O(carved submodules · length of a shadow) a pass, beside the pictures.
class OneLightSearch final : public DepthSolver {
 public:
  OneLightSearch(CarvingTarget target, const OneLightOptions& options);

  void update(std::span<const double> luminance) override;

  bool finished() const override { return finished_; }
  int iterations() const override { return passes_; }
  double doneFraction() const override;
  const DepthField& depths() const override { return depths_; }
  std::size_t limitedCount() const override;

 private:
  enum class State : std::uint8_t { TooBright, Done, Limited };
  struct Floor {
    std::uint32_t submodule = 0;  // index in the mask
    std::size_t module = 0;
    double tangent = 0;   // of the lamp's elevation over its surroundings; 0: they are not lit
    double fraction = 0;  // that is to lie in shadow; more than 1: beyond
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
  std::vector<Floor> floors_;  // from the lamp's side on
  int passes_ = 0;
  bool finished_ = false;
};

}  // namespace qrelief
