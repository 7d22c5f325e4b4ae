// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/print_decal.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/code_on_surface.h"
#include "engine/symbol_decal.h"
#include "verification/reading_sweep.h"

namespace qrelief {
namespace {

constexpr double kPaperQuantile = 0.8;  // quantile of the greys that is taken as the uncarved surface
constexpr double kSoftModules = 2;      // width of the soft edge

std::uint8_t paperOf(std::span<const std::uint8_t> pixels) {
  std::vector<std::uint8_t> sorted(pixels.begin(), pixels.end());
  const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(kPaperQuantile * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), at, sorted.end());
  return std::max<std::uint8_t>(1, *at);
}

/// Returns the light of an sRGB grey, 0 … 1 [IEC 61966-2-1].
double lightOf(double grey) {
  const double value = grey / 255;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace

Result<Decal> printDecal(const LoadedModel& model, const Placement& placement, std::span<const std::uint8_t> pixels,
                         int size, bool isShadow) {
  const double edgeModules = placement.symbolMm / placement.moduleMm + 2 * kPictureMarginModules;
  const double softPx = kSoftModules * size / edgeModules;
  const double paper = lightOf(paperOf(pixels));
  Decal decal;
  decal.frame = placement.frame;
  decal.edgeMm = edgeModules * placement.moduleMm;
  decal.size = size;
  decal.isInkOnly = true;
  decal.colours.ink = Vec3f(0);
  decal.ink.resize(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const int row = static_cast<int>(i) / size, column = static_cast<int>(i) % size;
    const int fromEdge = std::min({row, column, size - 1 - row, size - 1 - column});
    const double light = std::min(1.0, lightOf(pixels[i]) / paper);
    const double ink = (1 - std::pow(light, isShadow ? kShadowPower : 1)) * std::min(1.0, fromEdge / softPx);
    decal.ink[i] = static_cast<std::uint8_t>(std::lround(255 * ink));
  }
  return onVisibleSurface(model, std::move(decal));
}

}  // namespace qrelief
