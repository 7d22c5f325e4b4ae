// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/hbao_light.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "math/angle.h"
#include "qr/module_pattern.h"

namespace qrelief::study {
namespace {

constexpr int kTile = 4;  // pixels along the edge of the repeated noise, as in Bavoil's program
constexpr LightSampling kLampPoints{2, 4};
constexpr double kSteepest = 1.57;  // radians, just below π/2, where the tangent is infinite

/// Returns a number in [0, 1) for each pixel of the tile, all different; `which` picks one of several orders.
double noise(int pixel, int which) {
  constexpr int kCount = kTile * kTile;
  const int order = which == 0 ? pixel * 7 : pixel * 5 + pixel / kTile * 3;
  return (order % kCount + 0.5) / kCount;
}

}  // namespace

HbaoLight::HbaoLight(HeightMap map, PlacementLightOptions options, const HbaoOptions& hbao)
    : map_(std::move(map)), options_(std::move(options)), hbao_(hbao), height_(map_.height) {
  assert(hbao_.directions > 0 && hbao_.steps > 0 && hbao_.pixelsPerSubmodule > 0 && hbao_.radiusModules > 0);
  pixelMm_ = map_.patchMm / hbao_.pixelsPerSubmodule;
  const double stepMm = hbao_.radiusModules * options_.moduleMm / hbao_.steps;
  for (int pixel = 0; pixel < kTile * kTile; ++pixel) {
    std::vector<Direction> directions;
    for (int k = 0; k < hbao_.directions; ++k) {
      const double turn = hbao_.isJittered ? noise(pixel, 0) : 0.5;
      const double angle = 2 * std::numbers::pi * (k + turn) / hbao_.directions;
      Direction direction{{std::cos(angle), std::sin(angle)}, {}};
      for (int step = 0; step < hbao_.steps; ++step) {
        const double shift = hbao_.isJittered ? noise(pixel, 1) : 0.5;
        direction.samples.push_back(direction.along * std::max((step + shift) * stepMm, pixelMm_));
      }
      directions.push_back(std::move(direction));
    }
    patterns_.push_back(std::move(directions));
  }
  if (!options_.lamps.empty()) lamps_.emplace(map_);
  uncarved_.assign(map_.height.size(), Received());
  received_ = uncarved_;
  depthsMm_.assign(map_.height.size(), 0.0f);
  std::vector<std::uint32_t> all(map_.height.size());
  for (std::uint32_t cell = 0; cell < all.size(); ++cell) all[cell] = cell;
  luminance(all, depthsMm_, options_.moduleMm);
  for (Received& received : received_) received.lampsUncarved = received.lamps;
  uncarved_ = received_;
}

/// Sets the heights of the floors: w of a point `depth` farther along its ray (light/height_map.h).
void HbaoLight::carve(std::span<const float> depthsMm) {
  const double eye = map_.eyeDistance;
  for (std::size_t cell = 0; cell < height_.size(); ++cell) {
    height_[cell] = map_.height[cell];
    if (depthsMm[cell] <= 0 || !map_.isSurface(cell)) continue;
    const auto size = static_cast<std::size_t>(map_.size);
    const std::size_t row = cell / size, column = cell % size;
    const Vec2 plane =
        (Vec2(static_cast<double>(column), static_cast<double>(row)) + 0.5 - Vec2(map_.size / 2.0)) * map_.patchMm;
    const double way = std::sqrt(glm::dot(plane, plane) + eye * eye);
    const double share =
        eye / (static_cast<double>(map_.height[cell]) + eye) + static_cast<double>(depthsMm[cell]) / way;
    height_[cell] = static_cast<float>(eye / share - eye);
  }
}

/// Returns the height of the pixel that contains a point of the plane; kNothing beyond the map.
double HbaoLight::heightAt(Vec2 plane) const {
  const double cornerMm = -map_.size * map_.patchMm / 2;
  const Vec2 middle = (glm::floor((plane - cornerMm) / pixelMm_) + 0.5) * pixelMm_ + cornerMm;
  const Vec2 patch = glm::floor(middle / map_.patchMm + map_.size / 2.0);
  if (patch.x < 0 || patch.y < 0 || patch.x >= map_.size || patch.y >= map_.size)
    return static_cast<double>(HeightMap::kNothing);
  const auto cell =
      static_cast<std::size_t>(patch.y) * static_cast<std::size_t>(map_.size) + static_cast<std::size_t>(patch.x);
  const Vec2 offset = middle - (patch + 0.5 - map_.size / 2.0) * map_.patchMm;
  return static_cast<double>(height_[cell]) + static_cast<double>(map_.slopeX[cell]) * offset.x +
         static_cast<double>(map_.slopeY[cell]) * offset.y;
}

/// Returns the light of the sky at a pixel's middle.
double HbaoLight::skyAt(Vec2 plane, std::size_t cell, const std::vector<Direction>& directions) const {
  const double own = heightAt(plane), radiusMm = hbao_.radiusModules * options_.moduleMm;
  const Vec2 slope(static_cast<double>(map_.slopeX[cell]), static_cast<double>(map_.slopeY[cell]));
  double hidden = 0;
  for (const Direction& direction : directions) {
    const double tangent = std::atan(glm::dot(slope, direction.along)) + toRadians(hbao_.angleBiasDeg);
    double highest = std::tan(std::min(tangent, kSteepest)), sine = std::sin(tangent);  // tangent and sine of h
    for (const Vec2& sample : direction.samples) {
      const double rise = heightAt(plane + sample) - own, run = glm::length(sample);
      if (rise <= highest * run) continue;
      const double distance = std::sqrt(rise * rise + run * run);
      if (distance >= radiusMm) continue;
      hidden += (hbao_.isAttenuated ? 1 - distance / radiusMm : 1) * (rise / distance - sine);
      highest = rise / run;
      sine = rise / distance;
    }
  }
  return 1 - hidden / static_cast<double>(directions.size());
}

void HbaoLight::measureSky(std::size_t cell) {
  const int pixels = hbao_.pixelsPerSubmodule;
  const int column = static_cast<int>(cell) % map_.size, row = static_cast<int>(cell) / map_.size;
  double sum = 0;
  for (int y = row * pixels; y < (row + 1) * pixels; ++y)
    for (int x = column * pixels; x < (column + 1) * pixels; ++x) {
      const Vec2 plane = (Vec2(x, y) + 0.5) * pixelMm_ - map_.size * map_.patchMm / 2;
      sum += skyAt(plane, cell, patterns_[static_cast<std::size_t>(y % kTile * kTile + x % kTile)]);
    }
  received_[cell].sky = received_[cell].pastWalls = static_cast<float>(sum / (pixels * pixels));
}

std::vector<float> HbaoLight::luminance(std::span<const std::uint32_t> cells, std::span<const float> depthsMm,
                                        double reachMm) {
  carve(depthsMm);
  depthsMm_.assign(depthsMm.begin(), depthsMm.end());
  constexpr std::size_t kChunk = 256;
  parallelFor((cells.size() + kChunk - 1) / kChunk, [&](std::size_t chunk) {
    const std::size_t end = std::min(cells.size(), (chunk + 1) * kChunk);
    for (std::size_t k = chunk * kChunk; k < end; ++k)
      if (map_.isSurface(cells[k])) measureSky(cells[k]);
  });
  if (lamps_) {
    std::vector<std::uint8_t> isMeasured(received_.size(), 0);
    for (const std::uint32_t cell : cells) isMeasured[cell] = 1;
    std::vector<Received> lit = received_;
    lamps_->carve(depthsMm);
    lamps_->measure({.sampling = kLampPoints, .reachMm = reachMm, .lamps = options_.lamps}, isMeasured, lit);
    for (const std::uint32_t cell : cells) received_[cell].lamps = lit[cell].lamps;
  }
  return luminancesOf(received_);
}

std::vector<float> HbaoLight::luminancesOf(const std::vector<Received>& received) const {
  const auto open = static_cast<float>(openIrradiance(options_.lamps));
  std::vector<float> luminance;
  luminance.reserve(received.size());
  for (const Received& cell : received) luminance.push_back((cell.sky + cell.lamps) / open);
  return luminance;
}

gl::Texture HbaoLight::textureOf(const std::vector<float>& values) const {
  return {map_.size, map_.size, gl::Format::R32F, values.data()};
}

}  // namespace qrelief::study
