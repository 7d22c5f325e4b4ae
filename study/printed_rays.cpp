// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/printed_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qrelief::study {
namespace {

constexpr int kBlockTexels = 8;         // along the edge
constexpr double kOnTriangleMm = 1e-6;  // a ray that begins this close to a triangle begins on it
constexpr float kNothing = -std::numeric_limits<float>::infinity();
constexpr double kNever = std::numeric_limits<double>::infinity();

/// Returns the step at which a coordinate that begins at `at` and grows by `step` leaves [low, high].
double exitDistance(double at, double step, double low, double high) {
  return step > 0 ? (high - at) / step : step < 0 ? (low - at) / step : kNever;
}

/// Returns the height of a cell's triangle at (x, y) in the cell.
double heightIn(const TexelCell& cell, bool second, double x, double y) {
  if (cell.risingDiagonal)
    return second ? cell.low + y * (cell.left - cell.low) + x * (cell.high - cell.left)
                  : cell.low + x * (cell.right - cell.low) + y * (cell.high - cell.right);
  return second ? cell.high + (1 - x) * (cell.left - cell.high) + (1 - y) * (cell.right - cell.high)
                : cell.low + x * (cell.right - cell.low) + y * (cell.left - cell.low);
}

/// Returns a value below 0 in the first triangle, above 0 in the second.
double sideOf(const TexelCell& cell, double x, double y) { return cell.risingDiagonal ? y - x : x + y - 1; }

}  // namespace

PrintedRays::PrintedRays(const PrintedSurface& surface)
    : frame_(surface.frame),
      texels_(surface.texels),
      blocks_((surface.texels + kBlockTexels - 1) / kBlockTexels),
      texelMm_(surface.texelMm) {
  heights_.reserve(surface.distanceMm.size());
  for (int row = 0; row < texels_; ++row)
    for (int column = 0; column < texels_; ++column) heights_.push_back(surface.height(column, row));
  blockTops_.assign(static_cast<std::size_t>(blocks_) * static_cast<std::size_t>(blocks_), kNothing);
  for (int row = 0; row < texels_; ++row)
    for (int column = 0; column < texels_; ++column)
      for (int k = 0; k < 4; ++k) {  // for each block with a cell that has this corner
        const int r = std::max(0, row - k / 2) / kBlockTexels, c = std::max(0, column - k % 2) / kBlockTexels;
        float& top = blockTops_[r * blocks_ + c];
        top = std::max(top, heightAt(column, row));
      }
}

Vec3 PrintedRays::position(int column, int row) const {
  const double x = (column + 0.5 - texels_ / 2.0) * texelMm_, y = (row + 0.5 - texels_ / 2.0) * texelMm_;
  const double scale = frame_.eyeDistance / (static_cast<double>(heightAt(column, row)) + frame_.eyeDistance);
  return frame_.eye() + (frame_.right * x + frame_.up * y - frame_.normal * frame_.eyeDistance) * scale;
}

/// @returns none where a texel is missing
std::optional<TexelCell> PrintedRays::cellAt(int column, int row) const {
  const float low = heightAt(column, row), right = heightAt(column + 1, row);
  const float left = heightAt(column, row + 1), high = heightAt(column + 1, row + 1);
  if (std::min(std::min(low, right), std::min(left, high)) == kNothing) return std::nullopt;
  return TexelCell{static_cast<double>(low), static_cast<double>(right), static_cast<double>(left),
                   static_cast<double>(high), std::abs(low - high) <= std::abs(right - left)};
}

Vec3 PrintedRays::normalAt(const SurfacePoint& at) const {
  const int number = static_cast<int>(at.triangle / 2), column = number % texels_, row = number / texels_;
  const bool second = at.triangle % 2 != 0;
  const auto cell = cellAt(column, row);
  if (!cell) return frame_.normal;
  const Vec3 low = position(column, row), right = position(column + 1, row);
  const Vec3 left = position(column, row + 1), high = position(column + 1, row + 1);
  if (cell->risingDiagonal)
    return glm::normalize(second ? glm::cross(high - low, left - low) : glm::cross(right - low, high - low));
  return glm::normalize(second ? glm::cross(high - right, left - right) : glm::cross(right - low, left - low));
}

std::optional<SurfacePoint> PrintedRays::firstHit(Vec3 origin, Vec3 direction, double from) const {
  const Vec3 fromEye = origin - frame_.eye();
  MapRay ray;
  ray.depth = -glm::dot(fromEye, frame_.normal);
  ray.depthStep = -glm::dot(direction, frame_.normal);
  const double eye = frame_.eyeDistance;
  if (ray.depth < kOnTriangleMm) return seenFromEye(direction, from);
  const Vec2 across(glm::dot(fromEye, frame_.right), glm::dot(fromEye, frame_.up));
  const Vec2 acrossStep(glm::dot(direction, frame_.right), glm::dot(direction, frame_.up));
  const Vec2 at = across * (eye / ray.depth / texelMm_) + (texels_ - 1) / 2.0;
  const Vec2 step = (acrossStep - across * (ray.depthStep / ray.depth)) * (eye / texelMm_);
  ray.at = Vec3(at, eye * eye / ray.depth - eye);
  ray.step = Vec3(step, -eye * eye * ray.depthStep / ray.depth);

  double begin = ray.place(from);
  double end = ray.depthStep > 0 ? 1 / ray.depthStep : kNever;  // infinitely far away
  for (int axis = 0; axis < 2; ++axis) {
    if (ray.step[axis] == 0) {
      if (ray.at[axis] < 0 || ray.at[axis] > texels_ - 1) return std::nullopt;
      continue;
    }
    begin = std::max(begin, exitDistance(ray.at[axis], -ray.step[axis], 0, texels_ - 1) * -1);
    end = std::min(end, exitDistance(ray.at[axis], ray.step[axis], 0, texels_ - 1));
  }
  return begin < end ? walk(ray, begin, end, origin, direction) : std::nullopt;
}

std::optional<SurfacePoint> PrintedRays::seenFromEye(Vec3 direction, double from) const {
  const double depthStep = -glm::dot(direction, frame_.normal), eye = frame_.eyeDistance;
  if (depthStep <= 0) return std::nullopt;
  const Vec2 across(glm::dot(direction, frame_.right), glm::dot(direction, frame_.up));
  const Vec2 at = across * (eye / depthStep / texelMm_) + (texels_ - 1) / 2.0;
  if (!(at.x >= 0 && at.y >= 0 && at.x <= texels_ - 1 && at.y <= texels_ - 1)) return std::nullopt;
  const int column = std::min(static_cast<int>(at.x), texels_ - 2), row = std::min(static_cast<int>(at.y), texels_ - 2);
  const auto cell = cellAt(column, row);
  if (!cell) return std::nullopt;
  const double x = at.x - column, y = at.y - row;
  const bool second = sideOf(*cell, x, y) > 0;
  const double parameter = eye * eye / (heightIn(*cell, second, x, y) + eye) / depthStep;
  if (parameter <= from) return std::nullopt;
  return SurfacePoint{frame_.eye() + direction * parameter,
                      static_cast<std::uint32_t>(2 * (row * texels_ + column) + second),
                      parameter * glm::length(direction)};
}

std::optional<SurfacePoint> PrintedRays::walk(const MapRay& ray, double begin, double end, Vec3 origin,
                                              Vec3 direction) const {
  const int last = texels_ - 2;  // cell along the edge
  const auto cellOf = [&](double coordinate, double step) {
    // On a border, take the cell that the ray enters.
    const double cell = step < 0 ? std::ceil(coordinate) - 1 : std::floor(coordinate);
    return std::clamp(static_cast<int>(cell), 0, last);
  };
  const Vec3 first = ray.point(begin);
  int column = cellOf(first.x, ray.step.x), row = cellOf(first.y, ray.step.y);
  // wasAbove: the ray was above the surface so far; valid only if isKnown
  bool isFirst = true, wasAbove = true, isKnown = false;
  for (double s = begin; s < end;) {
    const int blockColumn = column / kBlockTexels, blockRow = row / kBlockTexels;
    const double top = static_cast<double>(blockTops_[blockRow * blocks_ + blockColumn]);
    const double outX =
        exitDistance(ray.at.x, ray.step.x, blockColumn * kBlockTexels, (blockColumn + 1) * kBlockTexels);
    const double outY = exitDistance(ray.at.y, ray.step.y, blockRow * kBlockTexels, (blockRow + 1) * kBlockTexels);
    const double out = std::min({outX, outY, end});
    if (std::min(ray.point(s).z, ray.point(out).z) > top) {
      if (out >= end) return std::nullopt;
      const Vec3 there = ray.point(out);
      const int lowColumn = blockColumn * kBlockTexels, lowRow = blockRow * kBlockTexels;
      column = outX <= outY ? (ray.step.x > 0 ? lowColumn + kBlockTexels : lowColumn - 1)
                            : std::clamp(cellOf(there.x, ray.step.x), lowColumn, lowColumn + kBlockTexels - 1);
      row = outX <= outY ? std::clamp(cellOf(there.y, ray.step.y), lowRow, lowRow + kBlockTexels - 1)
                         : (ray.step.y > 0 ? lowRow + kBlockTexels : lowRow - 1);
      if (column < 0 || row < 0 || column > last || row > last) return std::nullopt;
      s = std::max(s, out);
      isFirst = false;
      wasAbove = isKnown = true;
      continue;
    }

    const double cellOutX = exitDistance(ray.at.x, ray.step.x, column, column + 1);
    const double cellOutY = exitDistance(ray.at.y, ray.step.y, row, row + 1);
    const double cellOut = std::max(s, std::min({cellOutX, cellOutY, end}));
    const auto cell = cellAt(column, row);
    if (!cell) {
      isKnown = false;
    } else {
      const auto over = [&](double place, bool second) {
        const Vec3 p = ray.point(place);
        return p.z - heightIn(*cell, second, p.x - column, p.y - row);
      };
      const Vec3 in = ray.point(s), leaves = ray.point(cellOut);
      const double sideIn = sideOf(*cell, in.x - column, in.y - row);
      const double sideOut = sideOf(*cell, leaves.x - column, leaves.y - row);
      const bool crosses = (sideIn > 0) != (sideOut > 0);
      const double middle = crosses ? s + (cellOut - s) * (sideIn / (sideIn - sideOut)) : cellOut;
      double from = s;
      for (int part = 0; part < (crosses ? 2 : 1); ++part) {
        const bool second = part == 0 && crosses ? sideIn > 0 : sideOut > 0;
        const double to = part == 0 ? middle : cellOut;
        const double overFrom = over(from, second), overTo = over(to, second);
        if (isFirst && std::abs(overFrom) < kOnTriangleMm) {
          wasAbove = overTo > -kOnTriangleMm;
        } else {
          if (!isKnown) wasAbove = overFrom >= 0;
          if (wasAbove && overTo < 0) {
            const double share = std::clamp(overFrom / (overFrom - overTo), 0.0, 1.0);
            const double parameter = ray.parameter(from + (to - from) * share);
            return SurfacePoint{origin + direction * parameter,
                                static_cast<std::uint32_t>(2 * (row * texels_ + column) + second),
                                parameter * glm::length(direction)};
          }
          wasAbove = overTo >= 0;
        }
        isFirst = false;
        isKnown = true;
        from = to;
      }
    }
    isFirst = false;
    if (cellOut >= end) return std::nullopt;
    s = cellOut;
    if (cellOutX <= cellOutY)
      column += ray.step.x > 0 ? 1 : -1;
    else
      row += ray.step.y > 0 ? 1 : -1;
    if (column < 0 || row < 0 || column > last || row > last) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace qrelief::study
