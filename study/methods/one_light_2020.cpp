// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/one_light_2020.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/clock.h"
#include "base/halton.h"
#include "base/parallel.h"
#include "qr/codewords.h"
#include "study/methods/symbol_flips_2019.h"
#include "study/methods/white_reference.h"
#include "study/pass_rays.h"
#include "verification/light_path.h"

namespace qrelief::study {
namespace {

constexpr double kGreyScale = 255;
constexpr double kLampToSky = 456.0 / 24;  // as in the grey model

constexpr double kUnseen = -1;

/// Returns L·n where the lamp is visible, else 0; kUnseen if the eye sees nothing there.
PassRays::Cast lampAt(const CarvedSurface& surface, std::uint32_t submodule, Vec2 place, Vec3 towardsLamp) {
  const auto at = surface.pointOf(submodule, place);
  if (!at) return {kUnseen, std::nullopt};
  const double cosine = glm::dot(surface.normalAt(*at), towardsLamp);
  if (cosine <= 0) return {0, std::nullopt};
  const auto hit = surface.hitFrom(*at, towardsLamp);
  if (!hit) return {cosine, std::nullopt};
  return {0, hit->position};
}

/// Returns the mean of lampAt() over a submodule. @param k  of the submodule in `rays`
double lampOn(PassRays& rays, const CarvedSurface& surface, std::size_t k, Vec3 towardsLamp) {
  double sum = 0;
  int hits = 0;
  for (std::uint32_t i = 0; i < kLampPoints; ++i) {
    const auto place = halton23(i + 1);
    const double lamp =
        rays.value(k, i, [&] { return lampAt(surface, rays.submodules()[k], Vec2(place[0], place[1]), towardsLamp); });
    if (lamp == kUnseen) continue;
    sum += lamp;
    ++hits;
  }
  return hits > 0 ? sum / hits : 1;
}

bool isLight(const Symbol& symbol, int row, int column) {
  return row < 0 || column < 0 || row >= symbol.size || column >= symbol.size || !symbol.isDark(row, column);
}

bool isLightAround(const Symbol& symbol, int row, int column) {
  return isLight(symbol, row, column) && isLight(symbol, row - 1, column) && isLight(symbol, row + 1, column) &&
         isLight(symbol, row, column - 1) && isLight(symbol, row, column + 1);
}

}  // namespace

int oneLightGrey(double sky, double lamp) {
  return static_cast<int>(19.6 * std::pow(0.87 * (24 * sky + 456 * lamp), 0.3441) + 21.24);
}

void breakUpRuns2020(Symbol& symbol) {
  const CodewordLayout layout = layoutCodewords(symbol);
  std::vector<int> left(static_cast<std::size_t>(layout.structure.blocks), flipBudget2019(symbol));
  std::vector<char> isSpoilt(layout.blockOfCodeword.size(), 0);
  symbol.flipped = {symbol.size, symbol.size};
  const auto flip = [&](int row, int column) {
    const auto module = static_cast<std::size_t>(row * symbol.size + column);
    if (symbol.roles[module] != ModuleRole::Data) return false;
    if (const int codeword = layout.codewordOfModule[module]; codeword >= 0) {
      int& budget = left[static_cast<std::size_t>(layout.blockOfCodeword[static_cast<std::size_t>(codeword)])];
      char& spoilt = isSpoilt[static_cast<std::size_t>(codeword)];
      if (!spoilt && budget == 0) return false;
      budget -= !spoilt;
      spoilt = 1;
    }
    symbol.dark[module] = 0;
    symbol.flipped[module] = 1;
    return true;
  };
  for (int row = 0; row < symbol.size; ++row)
    for (int begin = 0, end = 0; begin < symbol.size; begin = std::max(end, begin + 1)) {
      for (end = begin; end < symbol.size && symbol.isDark(row, end);) ++end;
      const int length = end - begin;
      if (length <= 3) continue;
      const int at = begin + (length >= 6 ? 3 : length / 2);
      if (flip(row, at)) end = at + 1;  // modules to its right form a run of their own
    }
}

std::vector<std::uint8_t> lockedModules2020(const Symbol& symbol) {
  const CodewordLayout layout = layoutCodewords(symbol);
  const int needed = layout.structure.correctable() + 1;
  std::vector<std::uint8_t> locked(symbol.dark.size(), 0);
  std::vector<char> isSpoilt(layout.blockOfCodeword.size(), 0);
  int spoilt = 0;
  Symbol withLock = symbol;
  for (int row = 0; row < symbol.size; ++row)
    for (int column = 0; column < symbol.size && spoilt < needed; ++column) {
      const auto module = static_cast<std::size_t>(row * symbol.size + column);
      const int codeword = layout.codewordOfModule[module];
      if (codeword < 0 || layout.blockOfCodeword[static_cast<std::size_t>(codeword)] != 0) continue;
      if (isSpoilt[static_cast<std::size_t>(codeword)] || !isLightAround(withLock, row, column)) continue;
      isSpoilt[static_cast<std::size_t>(codeword)] = 1;
      ++spoilt;
      locked[module] = withLock.dark[module] = 1;
    }
  return spoilt < needed ? std::vector<std::uint8_t>() : locked;
}

Result<CarvedCode> carveOneLight2020(const StudyPlacement& spot, const Symbol& symbol, const SubmoduleMask& mask,
                                     const OneLightOptions& options) {
  const auto start = Clock::now();
  CarvedCode code{symbol, mask, {mask.rows(), spot.placement.symbolMm, {}}, {}};
  const std::vector<std::uint8_t> locked = options.lock ? lockedModules2020(symbol) : std::vector<std::uint8_t>();
  const auto moduleOf = [&](std::uint32_t i) {
    const auto row = i / static_cast<std::uint32_t>(mask.rows()) / kSubmodulesPerModule,
               column = i % static_cast<std::uint32_t>(mask.rows()) / kSubmodulesPerModule;
    return row * static_cast<std::uint32_t>(symbol.size) + column;
  };
  for (std::uint32_t i = 0; i < mask.size() && !locked.empty(); ++i)
    if (locked[moduleOf(i)]) code.mask[i] = 1;
  const std::vector<double> limitMm = spot.limitsMm(code.mask, options.maxDepthModules * spot.placement.moduleMm);
  const double stepMm = options.stepSubmodules * spot.submoduleMm();
  code.depths.depthMm.assign(mask.size(), 0);
  const std::vector<std::uint32_t> dark = carvedOf(code.mask);
  std::vector<std::uint32_t> light;
  for (std::uint32_t i = 0; i < mask.size(); ++i)
    if (!symbol.dark[moduleOf(i)] && !code.mask[i]) light.push_back(i);

  const auto lampFrom = [&](double elevationDeg) {
    return lampOf({options.azimuthDeg, elevationDeg, kLampToSky}, spot.placement.frame, 0).towards;
  };
  const Vec3 upper = lampFrom(options.upperElevationDeg), lower = lampFrom(options.lowerElevationDeg);
  double target = 0;
  {
    const auto uncarved = CarvedSurface::make(spot, code.depths);
    QRELIEF_TRY(uncarved);
    std::vector<double> greys(light.size());
    PassRays skyRays(light, options.rays), lampRays(light, kLampPoints);
    skyRays.begin(spot.placement.frame, code.depths);
    lampRays.begin(spot.placement.frame, code.depths);
    parallelFor(light.size(), [&](std::size_t k) {
      const std::uint64_t seed = options.seed * 1000003 + light[k];
      const double sky = skySeen(skyRays, *uncarved, k, options.rays, seed).value_or(SkySeen{1, 0}).cosineWeighted;
      greys[k] = oneLightGrey(sky, lampOn(lampRays, *uncarved, k, upper));
    });
    target = whiteReference(std::move(greys)) - kGreyScale * options.contrast;
  }
  for (const std::uint32_t i : dark) code.depths.depthMm[i] = quantisedDepth(stepMm, limitMm[i]);
  PassRays rays(dark, kLampPoints);
  for (bool deepened = true; deepened && code.passes < options.maxPasses;) {
    ++code.passes;
    const auto carved = CarvedSurface::make(spot, code.depths);
    QRELIEF_TRY(carved);
    std::vector<double> lamp(dark.size());
    rays.begin(spot.placement.frame, code.depths);
    parallelFor(dark.size(), [&](std::size_t k) {
      const bool isLocked = !locked.empty() && locked[moduleOf(dark[k])];
      lamp[k] = lampOn(rays, *carved, k, isLocked ? lower : upper);
    });
    deepened = false;
    code.limited = 0;
    code.ownEstimate.clear();
    for (std::size_t k = 0; k < dark.size(); ++k) {
      code.ownEstimate.push_back((24 + 456 * lamp[k]) / (24 + 456 * glm::dot(upper, spot.placement.frame.normal)));
      if (oneLightGrey(1, lamp[k]) <= target) continue;
      double& depth = code.depths.depthMm[dark[k]];
      const double deeper = quantisedDepth(depth + stepMm, limitMm[dark[k]]);
      deepened = deepened || deeper > depth;
      code.limited += deeper <= depth || code.passes == options.maxPasses;
      depth = std::max(depth, deeper);
    }
  }
  code.readUnder = DirectionalLight{options.azimuthDeg, options.upperElevationDeg, kLampToSky};
  code.milliseconds = millisecondsSince(start);
  return code;
}

}  // namespace qrelief::study
