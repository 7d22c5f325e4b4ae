// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/decal_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace qrelief {
namespace {

constexpr double kMostHeight = 0.75;    // as in view_decal.frag
constexpr double kOutlineShare = 0.1;   // limit, as a part of the edge: two and a half pixels of at most 0.02 on either
                                        // side
constexpr double kMarginPx = 4;         // for pixels at a contour, whose footprint is larger
constexpr double kToleranceTexels = 2;  // of the reach: slightly lower surface counts as visible, too
constexpr double kNearest = 0.02;       // as a part of the camera's distance: nearer points may project anywhere on the
                                        // canvas

struct Range {
  double low = 0, high = 0;  // the plane itself is drawn where no surface takes the decal
};

Range heightsUnder(const Decal& decal) {
  const double most = kMostHeight * decal.edgeMm;
  if (!decal.reach) return {-most, most};
  const VisibilityMap& reach = *decal.reach;
  const double texelMm = reach.window.texelMm();
  const double radius = (1 + kOutlineShare) * decal.edgeMm / std::numbers::sqrt2 + 2 * texelMm;
  if (radius > reach.window.extentMm / 2) return {-most, most};
  Range heights;
  for (int row = 0; row < reach.window.texels; ++row) {
    for (int column = 0; column < reach.window.texels; ++column) {
      if (glm::length(reach.window.planePoint(column, row)) > radius) continue;
      const auto i = 4 * static_cast<std::size_t>(row * reach.window.texels + column);
      const auto height = static_cast<double>(reach.texels[i]);
      if (height <= static_cast<double>(VisibilityMap::kNothing))
        return {-most, most};  // a contour: too coarse to know
      const double slope = std::hypot(reach.texels[i + 2], reach.texels[i + 3]);
      const double margin = kToleranceTexels * (1 + slope) * texelMm;
      heights.low = std::min(heights.low, height - margin);
      heights.high = std::max(heights.high, height + margin);
    }
  }
  return {std::max(heights.low, -most), std::min(heights.high, most)};
}

}  // namespace

PixelBox decalBounds(const Decal& decal, const CameraView& camera, int width, int height) {
  const PixelBox all{0, 0, width, height};
  const ProjectionFrame& frame = decal.frame;
  const Range heights = heightsUnder(decal);
  Vec2 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const double above : {heights.low, heights.high}) {
    const double scale = (frame.eyeDistance - above) / frame.eyeDistance;
    if (scale <= 0) return all;
    for (int corner = 0; corner < 4; ++corner) {
      const Vec2 onPlane =
          Vec2(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5) * ((1 + kOutlineShare) * decal.edgeMm * scale);
      const Vec3 point = frame.onPlane(onPlane) + frame.normal * above - camera.target;
      const double ahead = camera.distance - glm::dot(point, camera.back);
      if (ahead < kNearest * camera.distance) return all;
      const Vec2 ndc = Vec2(glm::dot(point, camera.right), glm::dot(point, camera.up)) / (ahead * camera.tanHalf);
      const Vec2 pixel = (ndc + 1.0) / 2.0 * Vec2(width, height);
      low = glm::min(low, pixel);
      high = glm::max(high, pixel);
    }
  }
  const auto clamped = [](double at, int most) { return static_cast<int>(std::clamp(at, 0.0, double(most))); };
  const int x = clamped(std::floor(low.x - kMarginPx), width), y = clamped(std::floor(low.y - kMarginPx), height);
  return {x, y, clamped(std::ceil(high.x + kMarginPx), width) - x, clamped(std::ceil(high.y + kMarginPx), height) - y};
}

}  // namespace qrelief
