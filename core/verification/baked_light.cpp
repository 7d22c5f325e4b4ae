// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/baked_light.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "base/halton.h"
#include "base/parallel.h"
#include "math/angle.h"

namespace qrelief {
namespace {

/// Distance, in texels, up to which a baked texel gives its light to a point. On a steep surface, points that project
/// into the same texel lie this far apart.
constexpr double kNearTexels = 3;
/// Two texels share a floor if each one's point lies within this fraction of a texel of the other's plane.
constexpr double kSameFloor = 0.3;

/// Block edge in texels, and the order in which a block's texels take points: neighbouring texels take distant points
/// [Bayer 1973].
constexpr int kBlock = 4;
constexpr std::array<int, 16> kBlockOrder = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
constexpr std::uint64_t kBlocksApart = 1u << 20;  // larger than the number of columns of a picture

/// Returns true if the two points lie in each other's tangent planes.
bool sameFloor(Vec3 a, Vec3 normalA, Vec3 b, Vec3 normalB, double texelMm) {
  const double across = kSameFloor * texelMm;
  return normalA != Vec3(0) && normalB != Vec3(0) && std::abs(glm::dot(b - a, normalA)) < across &&
         std::abs(glm::dot(b - a, normalB)) < across;
}

}  // namespace

BakedLight::BakedLight(const RaySurface& surface, const ProjectionFrame& frame, const BakeOptions& options)
    : surface_(&surface),
      frame_(frame),
      options_(options),
      texels_(options.texels, options.texels),
      light_(options.texels, options.texels, {-1, -1}) {
  assert(options.texels > 2 * options.border && options.border >= 0 && options.paths > 0 && options.texelMm > 0);
}

SurfaceLight BakedLight::traced(const SurfacePoint& at, Vec3 seen, int row, int column) const {
  // The texels of a block take their first directions from one set of points, shifted as a whole. An excess in one
  // texel is a deficit in its neighbours, so a camera's blur removes most of the error.
  Random block(static_cast<std::uint64_t>(row / kBlock) * kBlocksApart + static_cast<std::uint64_t>(column / kBlock));
  const double shiftU = block.uniform(), shiftV = block.uniform();
  const int first = kBlockOrder[row % kBlock * kBlock + column % kBlock] * options_.paths;
  Random random(static_cast<std::uint64_t>(row) * kBlocksApart + static_cast<std::uint64_t>(column));
  SurfaceLight sum;
  for (int i = 1; i <= options_.paths; ++i) {
    const auto point = halton23(static_cast<std::uint32_t>(first + i));
    const LightPath one = traceLight(*surface_, at, seen, {wrapped(point[0] + shiftU), wrapped(point[1] + shiftV)},
                                     options_.albedo, options_.lamps, random);
    sum.sky += one.sky;
    sum.lamp += one.lamp;
  }
  return {sum.sky / options_.paths, sum.lamp / options_.paths};
}

void BakedLight::bakeTexel(int row, int column) {
  const double middle = options_.texels / 2.0;
  const Vec2 at{(column + 0.5 - middle) * options_.texelMm, (row + 0.5 - middle) * options_.texelMm};
  const Vec3 ray = frame_.rayDirection(at);
  const auto hit = surface_->firstHit(frame_.eye(), ray);
  if (!hit) return;
  const Vec3 normal = surface_->normalAt(*hit);
  texels_.at(row, column) = {hit->position, glm::dot(normal, ray) > 0 ? -normal : normal};
  if (options_.isTraced) light_.at(row, column) = traced(*hit, ray, row, column);
}

bool BakedLight::bakeRows(int rows) {
  const int end = std::min(options_.texels, baked_ + rows), last = options_.texels - options_.border;
  parallelFor(end - baked_, [&](int i) {
    const int row = baked_ + i;
    if (row < options_.border || row >= last) return;
    for (int column = options_.border; column < last; ++column) bakeTexel(row, column);
  });
  baked_ = end;
  return baked_ == options_.texels;
}

void BakedLight::setLight(BottomUp<SurfaceLight> light) {
  assert(baked_ == options_.texels && light.size() == light_.size());
  for (std::size_t texel = 0; texel < light.size(); ++texel)
    light_[texel] = texels_[texel].normal == Vec3(0) ? SurfaceLight{-1, -1} : light[texel];
}

void BakedLight::smooth() {
  const BottomUp<SurfaceLight> before = light_;
  parallelFor(options_.texels, [&](int row) {
    for (int column = 0; column < options_.texels; ++column) {
      const Texel& a = texels_.at(row, column);
      if (a.normal == Vec3(0)) continue;
      SurfaceLight sum;
      int count = 0;
      for (int k = 0; k < 9; ++k) {
        const int r = row + k / 3 - 1, c = column + k % 3 - 1;
        if (!texels_.contains(r, c)) continue;
        const Texel& b = texels_.at(r, c);
        if (!sameFloor(a.position, a.normal, b.position, b.normal, options_.texelMm)) continue;
        sum.sky += before.at(r, c).sky;
        sum.lamp += before.at(r, c).lamp;
        ++count;
      }
      if (count > 0) light_.at(row, column) = {sum.sky / count, sum.lamp / count};
    }
  });
}

SurfaceLight BakedLight::lightAt(const SurfacePoint& at, Vec3 seen, int row, int column) const {
  if (frame_.distanceAlongAxis(at.position) > 0) {
    const Vec2 place = frame_.project(at.position) / options_.texelMm + Vec2(options_.texels / 2.0);
    const double x = std::floor(place.x), y = std::floor(place.y);
    if (x >= 0 && y >= 0 && x < options_.texels && y < options_.texels) {
      const std::size_t texel = texels_.index(static_cast<int>(y), static_cast<int>(x));
      const Texel& baked = texels_[texel];
      const bool near = glm::length(baked.position - at.position) < kNearTexels * options_.texelMm;
      const Vec3 normal = surface_->normalAt(at);
      if (near && sameFloor(baked.position, baked.normal, at.position, normal, options_.texelMm)) return light_[texel];
    }
  }
  return traced(at, seen, row, column);
}

LinearPicture BakedLight::picture(const ProjectionFrame& camera, int texels, double texelMm, const InkMap* ink) const {
  assert(baked_ == options_.texels);
  const float addedBackground = kBackground * static_cast<float>(openLight() - 1);
  LinearPicture picture{{texels, texels, kBackground}, {texels, texels, addedBackground}};
  parallelFor(texels, [&](int row) {
    for (int column = 0; column < texels; ++column) {
      const double middle = texels / 2.0;
      const Vec2 at{(column + 0.5 - middle) * texelMm, (row + 0.5 - middle) * texelMm};
      const Vec3 ray = camera.rayDirection(at);
      const auto hit = surface_->firstHit(camera.eye(), ray);
      if (!hit) continue;
      const SurfaceLight light = lightAt(*hit, ray, row, column);
      const float factor = ink ? ink->factor(frame_.project(hit->position)) : 1.0f;
      picture.sky.at(row, column) = factor * static_cast<float>(light.sky);
      picture.added.at(row, column) = factor * static_cast<float>(light.lamp);
    }
  });
  return picture;
}

double BakedLight::openLight() const {
  double sum = 1;
  for (const Lamp& lamp : options_.lamps) sum += lamp.strength * std::max(glm::dot(frame_.normal, lamp.towards), 0.0);
  return sum;
}

ProjectionFrame tilted(const ProjectionFrame& frame, double tiltDeg, double azimuthDeg) {
  const double tilt = toRadians(tiltDeg), azimuth = toRadians(azimuthDeg);
  const Vec3 side = frame.right * std::cos(azimuth) + frame.up * std::sin(azimuth);
  return makeFrame(frame.centre, frame.normal * std::cos(tilt) + side * std::sin(tilt), frame.up, frame.eyeDistance);
}

}  // namespace qrelief
