// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/hbao_light.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "math/angle.h"
#include "qr/module_pattern.h"
#include "shaders.h"

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

/// HbaoLight::skyAt() of all pixels of a cell, a fragment a cell. It stands here because the page does not need it.
constexpr const char* kSkyShader = R"(#version 300 es
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

uniform sampler2D u_surface;  // slope to the right and up of each cell
uniform sampler2D u_height;   // height of each carved cell's middle, mm
uniform sampler2D u_samples;  // from a pixel's middle, mm; its direction. A row is a pixel of the tile
uniform float u_cells, u_cellMm;
uniform int u_pixels, u_tile;  // along the edge of a cell, of the tile
uniform int u_directions, u_steps;
uniform float u_radiusMm, u_bias;
uniform int u_isAttenuated;

layout(location = 0) out vec4 o_sky;

const float kNothing = -1e6, kSteepest = 1.57;

float heightAt(vec2 plane) {
  float cornerMm = -u_cells * u_cellMm / 2.0, pixelMm = u_cellMm / float(u_pixels);
  vec2 pixel = floor((plane - cornerMm) / pixelMm);
  vec2 cell = floor((pixel + 0.5) / float(u_pixels));
  if (any(lessThan(cell, vec2(0.0))) || any(greaterThanEqual(cell, vec2(u_cells)))) return kNothing;
  vec2 offset = (pixel + 0.5) * pixelMm - (cell + 0.5) * u_cellMm;
  return texelFetch(u_height, ivec2(cell), 0).r + dot(texelFetch(u_surface, ivec2(cell), 0).rg, offset);
}

float skyAt(vec2 plane, vec2 slope, int pattern) {
  float own = heightAt(plane), hidden = 0.0;
  for (int k = 0; k < u_directions; ++k) {
    vec2 along = texelFetch(u_samples, ivec2(k * u_steps, pattern), 0).ba;
    float tangent = atan(dot(slope, along)) + u_bias;
    float highest = tan(min(tangent, kSteepest)), sine = sin(tangent);  // tangent and sine of h
    for (int i = 0; i < u_steps; ++i) {
      vec2 offset = texelFetch(u_samples, ivec2(k * u_steps + i, pattern), 0).rg;
      float rise = heightAt(plane + offset) - own, run = length(offset);
      if (rise <= highest * run) continue;
      float distance = length(vec2(rise, run));
      if (distance >= u_radiusMm) continue;
      hidden += (u_isAttenuated == 1 ? 1.0 - distance / u_radiusMm : 1.0) * (rise / distance - sine);
      highest = rise / run;
      sine = rise / distance;
    }
  }
  return 1.0 - hidden / float(u_directions);
}

void main() {
  ivec2 cell = ivec2(gl_FragCoord.xy);
  vec2 slope = texelFetch(u_surface, cell, 0).rg;
  float sum = 0.0;
  for (int y = cell.y * u_pixels; y < (cell.y + 1) * u_pixels; ++y)
    for (int x = cell.x * u_pixels; x < (cell.x + 1) * u_pixels; ++x) {
      vec2 plane = (vec2(x, y) + 0.5) * (u_cellMm / float(u_pixels)) - u_cells * u_cellMm / 2.0;
      sum += skyAt(plane, slope, y % u_tile * u_tile + x % u_tile);
    }
  o_sky = vec4(sum / float(u_pixels * u_pixels), 0.0, 0.0, 1.0);
}
)";

}  // namespace

struct HbaoLight::Shader {
  gl::Program program;
  gl::Texture surface, height, samples, sky;
  gl::Framebuffer target;
};

HbaoLight::~HbaoLight() = default;

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

Status HbaoLight::useShader() {
  auto shader = std::make_unique<Shader>();
  auto program = gl::Program::create("hbao-sky", shaders::fullscreen_vert, kSkyShader);
  QRELIEF_TRY(program);
  shader->program = std::move(*program);
  std::vector<glm::vec4> surface, samples;
  for (std::size_t cell = 0; cell < map_.height.size(); ++cell)
    surface.emplace_back(map_.slopeX[cell], map_.slopeY[cell], 0, 0);
  for (const std::vector<Direction>& directions : patterns_)
    for (const Direction& direction : directions)
      for (const Vec2& sample : direction.samples) samples.emplace_back(sample, direction.along);
  shader->surface = {map_.size, map_.size, gl::Format::RGBA32F, surface.data()};
  shader->height = {map_.size, map_.size, gl::Format::R32F};
  shader->samples = {hbao_.directions * hbao_.steps, kTile * kTile, gl::Format::RGBA32F, samples.data()};
  shader->sky = {map_.size, map_.size, gl::Format::R32F};
  const gl::Texture* const colours[] = {&shader->sky};
  auto target = gl::Framebuffer::create(colours, false);
  QRELIEF_TRY(target);
  shader->target = std::move(*target);
  shader_ = std::move(shader);
  return {};
}

void HbaoLight::measureSkyByShader(std::span<const std::uint32_t> cells) {
  const gl::Program& program = shader_->program;
  shader_->height.upload(height_.data());
  shader_->target.bind();
  program.use();
  program.setTexture("u_surface", 0, shader_->surface);
  program.setTexture("u_height", 1, shader_->height);
  program.setTexture("u_samples", 2, shader_->samples);
  program.set("u_cells", static_cast<float>(map_.size));
  program.set("u_cellMm", static_cast<float>(map_.patchMm));
  program.set("u_pixels", hbao_.pixelsPerSubmodule);
  program.set("u_tile", kTile);
  program.set("u_directions", hbao_.directions);
  program.set("u_steps", hbao_.steps);
  program.set("u_radiusMm", static_cast<float>(hbao_.radiusModules * options_.moduleMm));
  program.set("u_bias", static_cast<float>(toRadians(hbao_.angleBiasDeg)));
  program.set("u_isAttenuated", hbao_.isAttenuated ? 1 : 0);
  gl::drawFullscreen();
  const std::vector<float> sky = shader_->target.readRed();
  for (const std::uint32_t cell : cells)
    if (map_.isSurface(cell)) received_[cell].sky = received_[cell].pastWalls = sky[cell];
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
  if (shader_) {
    measureSkyByShader(cells);
  } else {
    constexpr std::size_t kChunk = 256;
    parallelFor((cells.size() + kChunk - 1) / kChunk, [&](std::size_t chunk) {
      const std::size_t end = std::min(cells.size(), (chunk + 1) * kChunk);
      for (std::size_t k = chunk * kChunk; k < end; ++k)
        if (map_.isSurface(cells[k])) measureSky(cells[k]);
    });
  }
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
