// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/self_shadow_2019.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/clock.h"
#include "base/parallel.h"
#include "study/methods/white_reference.h"
#include "study/pass_rays.h"

namespace qrelief::study {
namespace {

constexpr double kGreyScale = 255;
constexpr double kMargin = 20;  // grey levels; an eighth of the rays errs by less

/// Measures the sky at the middle of a submodule.
SkySeen skyOf(PassRays& rays, const CarvedSurface& surface, std::size_t k, std::size_t count, std::uint64_t seed) {
  // Use the same rays in every pass: new noise in each pass would eventually make every submodule deeper once more.
  return skySeen(rays, surface, k, count, seed * 1000003 + rays.submodules()[k])
      .value_or(SkySeen{1, 2 * std::numbers::pi});
}

/// Returns the visibility of a dark sample.
double visibilityOf(const SkySeen& sky) { return sky.solidAngle / std::numbers::pi * sky.cosineWeighted; }

}  // namespace

double selfShadowGrey(double visibility) { return std::round(195.6 * std::pow(std::max(visibility, 0.0), 0.09219)); }

Result<CarvedCode> carveSelfShadow2019(const StudyPlacement& spot, const Symbol& symbol, const SubmoduleMask& mask,
                                       const SelfShadowOptions& options) {
  const auto start = Clock::now();
  const std::vector<double> limitMm = spot.limitsMm(mask, options.maxDepthModules * spot.placement.moduleMm);
  const double stepMm = options.stepModules * spot.placement.moduleMm;
  CarvedCode code{symbol, mask, {mask.rows(), spot.placement.symbolMm, {}}, {}};
  code.depths.depthMm.assign(mask.size(), 0);
  const std::vector<std::uint32_t> dark = carvedOf(mask);
  std::vector<std::uint32_t> light;
  std::vector<double> target(dark.size());
  for (std::uint32_t i = 0; i < mask.size(); ++i) {
    const int row = static_cast<int>(i) / mask.rows() / kSubmodulesPerModule;
    if (!symbol.isDark(row, static_cast<int>(i) % mask.rows() / kSubmodulesPerModule)) light.push_back(i);
  }
  {
    const auto uncarved = CarvedSurface::make(spot, code.depths);
    QRELIEF_TRY(uncarved);
    std::vector<double> greys(light.size());
    PassRays rays(light, options.rays);
    rays.begin(spot.placement.frame, code.depths);
    parallelFor(light.size(), [&](std::size_t k) {
      greys[k] = selfShadowGrey(skyOf(rays, *uncarved, k, options.rays, options.seed).cosineWeighted);
    });
    const double white = whiteReference(std::move(greys));
    for (std::size_t k = 0; k < dark.size(); ++k) {
      const int row = static_cast<int>(dark[k]) / mask.rows() / kSubmodulesPerModule,
                column = static_cast<int>(dark[k]) % mask.rows() / kSubmodulesPerModule;
      const bool isData = symbol.role(row, column) == ModuleRole::Data;
      target[k] = white - kGreyScale * (isData ? options.dataContrast : options.functionContrast);
    }
  }
  for (const std::uint32_t i : dark) code.depths.depthMm[i] = quantisedDepth(stepMm, limitMm[i]);
  PassRays rays(dark, options.rays);
  for (bool deepened = true; deepened && code.passes < options.maxPasses;) {
    ++code.passes;
    const auto carved = CarvedSurface::make(spot, code.depths);
    QRELIEF_TRY(carved);
    rays.begin(spot.placement.frame, code.depths);
    std::vector<double> visibility(dark.size());
    parallelFor(dark.size(), [&](std::size_t k) {
      const bool isAtLimit = code.depths.depthMm[dark[k]] >= limitMm[dark[k]];
      const auto by = [&](std::size_t count) {
        visibility[k] = visibilityOf(skyOf(rays, *carved, k, count, options.seed));
        return selfShadowGrey(visibility[k]);
      };
      isAtLimit ? by(options.rays) : measureUntilClear(options.rays, target[k], kMargin, by);
    });
    deepened = false;
    code.limited = 0;
    code.ownEstimate.clear();
    for (std::size_t k = 0; k < dark.size(); ++k) {
      code.ownEstimate.push_back(std::min(1.0, visibility[k]));
      if (selfShadowGrey(visibility[k]) <= target[k]) continue;
      double& depth = code.depths.depthMm[dark[k]];
      const double deeper = quantisedDepth(depth + stepMm, limitMm[dark[k]]);
      deepened = deepened || deeper > depth;
      code.limited += deeper <= depth || code.passes == options.maxPasses;
      depth = std::max(depth, deeper);
    }
  }
  code.milliseconds = millisecondsSince(start);
  return code;
}

}  // namespace qrelief::study
