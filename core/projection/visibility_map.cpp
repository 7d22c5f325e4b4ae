// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/visibility_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "projection/flatness.h"

namespace qrelief {
namespace {

constexpr float kSteepest = 0.1f;     // cosine of the steepest surface that the code can lie on
constexpr double kStepSlope = 10;     // steepest rise from texel to texel that is no jump
constexpr int kFractionSamples = 40;  // samples along the edge of the square that missingFraction() tests

std::size_t indexOf(int column, int row, int texels) {
  return 4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(texels) + static_cast<std::size_t>(column));
}

void flood(VisibilityMap& reach, const std::vector<float>& maps) {
  const int n = reach.window.texels;
  const auto jump = static_cast<float>(kStepSlope * reach.window.texelMm());
  const auto faces = [&](std::size_t i) { return maps[i + 2] > kSteepest; };
  std::vector<std::pair<int, int>> waiting;
  for (int column = (n - 1) / 2; column <= n / 2; ++column) {
    const std::size_t i = indexOf(column, n / 2, n);
    // Another surface may lie in front of the centre.
    if (!faces(i) || reach.texels[i + 1] > 0 || std::abs(reach.texels[i]) > jump) continue;
    reach.texels[i + 1] = 1;
    waiting.emplace_back(column, n / 2);
  }
  while (!waiting.empty()) {
    const auto [column, row] = waiting.back();
    waiting.pop_back();
    const float height = reach.texels[indexOf(column, row, n)];
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const int x = column + dx, y = row + dy;
      if (x < 0 || y < 0 || x >= n || y >= n) continue;
      const std::size_t i = indexOf(x, y, n);
      if (reach.texels[i + 1] > 0 || !faces(i) || std::abs(reach.texels[i] - height) > jump) continue;
      reach.texels[i + 1] = 1;
      waiting.emplace_back(x, y);
    }
  }
}

}  // namespace

bool VisibilityMap::isReached(int column, int row) const { return texels[indexOf(column, row, window.texels) + 1] > 0; }

float VisibilityMap::heightMm(int column, int row) const { return texels[indexOf(column, row, window.texels)]; }

double VisibilityMap::freeMm() const {
  double nearest = (window.extentMm + window.texelMm()) / 2;
  for (int row = 0; row < window.texels; ++row)
    for (int column = 0; column < window.texels; ++column)
      if (!isReached(column, row)) nearest = std::min(nearest, glm::length(window.planePoint(column, row)));
  return std::numbers::sqrt2 * std::max(0.0, nearest - window.texelMm() / 2);
}

double VisibilityMap::alignedMm(double turn) const {
  const double c = std::cos(turn), s = std::sin(turn);
  double nearest = (window.extentMm + window.texelMm()) / 2 / (std::abs(c) + std::abs(s));
  for (int row = 0; row < window.texels; ++row) {
    for (int column = 0; column < window.texels; ++column) {
      if (isReached(column, row)) continue;
      const Vec2 p = window.planePoint(column, row);
      nearest = std::min(nearest, std::max(std::abs(p.x * c + p.y * s), std::abs(p.y * c - p.x * s)));
    }
  }
  return 2 * std::max(0.0, nearest - window.texelMm() / 2);
}

double VisibilityMap::missingFraction(double edgeMm, double turn) const {
  const double c = std::cos(turn), s = std::sin(turn);
  int missing = 0;
  for (int row = 0; row < kFractionSamples; ++row) {
    for (int column = 0; column < kFractionSamples; ++column) {
      const Vec2 p = (Vec2(column + 0.5, row + 0.5) / static_cast<double>(kFractionSamples) - 0.5) * edgeMm;
      const Vec2 at =
          (Vec2(p.x * c - p.y * s, p.x * s + p.y * c) / window.extentMm + 0.5) * static_cast<double>(window.texels);
      const bool isInside = at.x >= 0 && at.y >= 0 && at.x < window.texels && at.y < window.texels;
      if (!isInside || !isReached(static_cast<int>(at.x), static_cast<int>(at.y))) ++missing;
    }
  }
  return static_cast<double>(missing) / (kFractionSamples * kFractionSamples);
}

double VisibilityMap::bendMm(double edgeMm, double turn) const {
  const double c = std::cos(turn), s = std::sin(turn);
  PlaneFit fit;
  for (int row = 0; row < window.texels; ++row) {
    for (int column = 0; column < window.texels; ++column) {
      const Vec2 p = window.planePoint(column, row);
      const bool isInside = std::max(std::abs(p.x * c + p.y * s), std::abs(p.y * c - p.x * s)) <= edgeMm / 2;
      if (isInside && isReached(column, row)) fit.add(p, static_cast<double>(heightMm(column, row)));
    }
  }
  return fit.rms();
}

void VisibilityMap::trust() {
  for (std::size_t i = 0; i < texels.size(); i += 4) texels[i + 1] = 1;
}

Result<VisibilityMap> lookAround(const SurfaceRenderer& surface, const ProjectionFrame& frame,
                                 const MapWindow& window) {
  const auto rendered = surface.render(frame, window);
  QRELIEF_TRY(rendered);
  const std::vector<float>& map = *rendered;
  VisibilityMap reach{frame, window, std::vector<float>(map.size())};
  for (std::size_t i = 0; i < map.size(); i += 4) {
    const float facing = std::max(map[i + 2], kSteepest);
    const bool isMet = map[i] != 0 || map[i + 1] != 0 || map[i + 2] != 0;
    reach.texels[i] = isMet ? map[i + 3] : VisibilityMap::kNothing;
    reach.texels[i + 1] = 0;
    reach.texels[i + 2] = -map[i] / facing;
    reach.texels[i + 3] = -map[i + 1] / facing;
  }
  flood(reach, map);
  return reach;
}

}  // namespace qrelief
