// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/self_shadow_2019.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/clock.h"
#include "base/parallel.h"
#include "study/carved_surface.h"
#include "study/methods/white_reference.h"

namespace qrelief::study {
namespace {

constexpr double kGreyScale = 255;

std::vector<SkySeen> skyOf(const CarvedSurface& surface, const std::vector<std::uint32_t>& submodules,
                           const SelfShadowOptions& options) {
  std::vector<SkySeen> seen(submodules.size());
  parallelFor(submodules.size(), [&](std::size_t k) {
    const auto at = surface.middleOf(submodules[k]);
    // Use the same rays in every pass: new noise in each pass would eventually make every submodule deeper once more.
    const std::uint64_t seed = options.seed * 1000003 + submodules[k];
    seen[k] = at ? skySeen(surface, *at, options.rays, seed) : SkySeen{1, 2 * std::numbers::pi};
  });
  return seen;
}

}  // namespace

double selfShadowGrey(double visibility) { return std::round(195.6 * std::pow(std::max(visibility, 0.0), 0.09219)); }

Result<CarvedCode> carveSelfShadow2019(const StudyPlacement& spot, const Symbol& symbol, const SubmoduleMask& mask,
                                       const SelfShadowOptions& options) {
  const auto start = Clock::now();
  const std::vector<double> limitMm = spot.limitsMm(mask, options.maxDepthModules * spot.placement.moduleMm);
  const double stepMm = options.stepModules * spot.placement.moduleMm;
  CarvedCode code{symbol, mask, {mask.size, spot.placement.symbolMm, {}}, {}};
  code.depths.depthMm.assign(mask.carved.size(), 0);
  const std::vector<std::uint32_t> dark = carvedOf(mask);
  std::vector<std::uint32_t> light;
  std::vector<double> target(dark.size());
  for (std::uint32_t i = 0; i < mask.carved.size(); ++i) {
    const int row = static_cast<int>(i) / mask.size / kSubmodulesPerModule;
    if (!symbol.isDark(row, static_cast<int>(i) % mask.size / kSubmodulesPerModule)) light.push_back(i);
  }
  {
    const auto uncarved = CarvedSurface::make(spot, code.depths);
    if (!uncarved) return tl::unexpected(uncarved.error());
    std::vector<double> greys;
    for (const SkySeen& seen : skyOf(*uncarved, light, options)) greys.push_back(selfShadowGrey(seen.cosineWeighted));
    const double white = whiteReference(std::move(greys));
    for (std::size_t k = 0; k < dark.size(); ++k) {
      const int row = static_cast<int>(dark[k]) / mask.size / kSubmodulesPerModule,
                column = static_cast<int>(dark[k]) % mask.size / kSubmodulesPerModule;
      const bool isData = symbol.role(row, column) == ModuleRole::Data;
      target[k] = white - kGreyScale * (isData ? options.dataContrast : options.functionContrast);
    }
  }
  for (const std::uint32_t i : dark) code.depths.depthMm[i] = quantisedDepth(stepMm, limitMm[i]);
  for (bool deepened = true; deepened && code.passes < options.maxPasses;) {
    ++code.passes;
    const auto carved = CarvedSurface::make(spot, code.depths);
    if (!carved) return tl::unexpected(carved.error());
    const std::vector<SkySeen> sky = skyOf(*carved, dark, options);
    deepened = false;
    code.limited = 0;
    code.ownEstimate.clear();
    for (std::size_t k = 0; k < dark.size(); ++k) {
      const double visibility = sky[k].solidAngle / std::numbers::pi * sky[k].cosineWeighted;
      code.ownEstimate.push_back(std::min(1.0, visibility));
      if (selfShadowGrey(visibility) <= target[k]) continue;
      double& depth = code.depths.depthMm[dark[k]];
      const double deeper = quantisedDepth(depth + stepMm, limitMm[dark[k]]);
      deepened = deepened || deeper > depth;
      code.limited += deeper <= depth;
      depth = std::max(depth, deeper);
    }
  }
  code.milliseconds = millisecondsSince(start);
  return code;
}

}  // namespace qrelief::study
