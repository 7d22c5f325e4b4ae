// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/groove_2018.h"

#include <algorithm>
#include <cmath>

#include "base/clock.h"
#include "base/parallel.h"
#include "study/pass_rays.h"

namespace qrelief::study {
namespace {

constexpr double kMargin = 0.15;  // an eighth of the rays errs by less

/// Returns the obscurance at the middle of a submodule; 1 = nothing near.
double obscurance(PassRays& rays, const CarvedSurface& surface, std::size_t k, std::size_t count, double falloffMm,
                  std::uint64_t seed) {
  double sum = 0;
  const auto all = static_cast<double>(count);
  const auto add = [&](double cosine, const std::optional<double>& distanceMm) {
    sum += 2 * cosine / all * (distanceMm ? 1 - std::exp(-*distanceMm / falloffMm) : 1);
  };
  return overHemisphere(rays, surface, k, count, seed, add) ? sum : 1;
}

}  // namespace

std::vector<double> bSplineValues(const std::vector<double>& control, int size) {
  const auto along = [size](const std::vector<double>& values, int rowStep, int columnStep) {
    const auto at = [&](int row, int column) {
      if (row < 0 || column < 0 || row >= size || column >= size) return 0.0;
      return values[static_cast<std::size_t>(row * size + column)];
    };
    std::vector<double> smooth;
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column)
        smooth.push_back(
            (at(row - rowStep, column - columnStep) + 4 * at(row, column) + at(row + rowStep, column + columnStep)) /
            6);
    return smooth;
  };
  return along(along(control, 1, 0), 0, 1);
}

Result<CarvedCode> carveGrooves2018(const StudyPlacement& spot, const Symbol& symbol, const SubmoduleMask& mask,
                                    const GrooveOptions& options) {
  const auto start = Clock::now();
  // A groove runs out over its neighbours, so these are carved, too.
  std::vector<double> reach(mask.begin(), mask.end());
  reach = bSplineValues(reach, mask.rows());
  SubmoduleMask grooved = mask;
  for (std::size_t i = 0; i < reach.size(); ++i) grooved[i] = reach[i] > 0;
  const double moduleMm = spot.placement.moduleMm;
  const std::vector<double> limitMm = spot.limitsMm(grooved, options.maxDepthModules * moduleMm);
  CarvedCode code{symbol, mask, {mask.rows(), spot.placement.symbolMm, {}}, {}};
  code.depths.depthMm.assign(mask.size(), 0);
  const std::vector<std::uint32_t> dark = carvedOf(mask);
  std::vector<std::uint32_t> light;
  for (std::uint32_t i = 0; i < mask.size(); ++i)
    if (!grooved[i]) light.push_back(i);

  const auto measured = [&](const CarvedSurface& surface, PassRays& rays, double target) {
    rays.begin(spot.placement.frame, code.depths);
    std::vector<double> values(rays.submodules().size());
    parallelFor(values.size(), [&](std::size_t k) {
      const std::uint32_t submodule = rays.submodules()[k];
      const auto by = [&](std::size_t count) {
        const std::uint64_t seed = options.seed * 1000003 + submodule;
        return obscurance(rays, surface, k, count, options.falloffModules * moduleMm, seed);
      };
      const bool isAtLimit = code.depths.depthMm[submodule] >= limitMm[submodule];
      values[k] = isAtLimit ? by(options.rays) : measureUntilClear(options.rays, target, kMargin, by);
    });
    return values;
  };
  double open = 0;
  {
    const auto uncarved = CarvedSurface::make(spot, code.depths);
    QRELIEF_TRY(uncarved);
    PassRays rays(light, options.rays);
    for (const double value : measured(*uncarved, rays, INFINITY)) open += value / static_cast<double>(light.size());
  }
  PassRays rays(dark, options.rays);
  std::vector<double> control(mask.size(), 0);
  const double stepMm = options.stepModules * moduleMm;
  for (const std::uint32_t i : dark) control[i] = stepMm;
  for (bool deepened = true; deepened && code.passes < options.maxPasses;) {
    ++code.passes;
    const std::vector<double> wantedMm = bSplineValues(control, mask.rows());
    for (std::size_t i = 0; i < wantedMm.size(); ++i)
      code.depths.depthMm[i] = wantedMm[i] > 0 ? quantisedDepth(wantedMm[i], limitMm[i]) : 0;
    const auto carved = CarvedSurface::make(spot, code.depths);
    QRELIEF_TRY(carved);
    code.ownEstimate = measured(*carved, rays, open * (1 - options.contrast));
    deepened = false;
    code.limited = 0;
    for (std::size_t k = 0; k < dark.size(); ++k) {
      code.ownEstimate[k] /= open;
      if (code.ownEstimate[k] <= 1 - options.contrast) continue;
      const bool isAtLimit = wantedMm[dark[k]] >= limitMm[dark[k]];
      code.limited += isAtLimit || code.passes == options.maxPasses;
      if (isAtLimit) continue;
      control[dark[k]] += stepMm;
      deepened = true;
    }
  }
  code.milliseconds = millisecondsSince(start);
  return code;
}

}  // namespace qrelief::study
