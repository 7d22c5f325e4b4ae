// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/nearby_centre.h"

#include <algorithm>
#include <cmath>

#include "math/angle.h"
#include "projection/flatness.h"
#include "projection/size_bound.h"

namespace qrelief {
namespace {

constexpr int kTexels = 160;
constexpr double kReachEdges = 0.5;  // how far to look, in edges of the square that the code needs ...
constexpr double kReachMm = 3;       // ... and added to it
constexpr double kNextSize = 0.85;   // ratio of one size tried to the previous
constexpr double kKeptSize = 0.8;    // least size at the new centre, of the size looked for
constexpr int kEstimates = 3;
constexpr double kLeastMoveTexels = 1.5;
constexpr double kMissing = 0.01;  // fraction of a fixed code's square that may be missing on the coarse map

/// Plane fits of the squares of a map, by sums over all texels to the lower left.
class SquareFits {
 public:
  explicit SquareFits(const VisibilityMap& map)
      : map_(&map), edge_(map.window.texels + 1), sums_(static_cast<std::size_t>(edge_) * edge_) {
    for (int row = 0; row + 1 < edge_; ++row) {
      PlaneFit line;
      for (int column = 0; column + 1 < edge_; ++column) {
        if (map.isReached(column, row))
          line.add(map.window.planePoint(column, row), static_cast<double>(map.heightMm(column, row)));
        PlaneFit& sum = sums_[indexOf(column + 1, row + 1)];
        sum = sums_[indexOf(column + 1, row)];
        sum += line;
      }
    }
  }

  /// Returns the middle of the square nearest to the map's centre that is reached everywhere and whose bend a code of
  /// that size tolerates; none if there is none.
  std::optional<Vec2> nearest(double symbolMm, double outerMm, int modules) const {
    const double texelMm = map_->window.texelMm();
    const int outer = static_cast<int>(std::ceil(outerMm / texelMm)), inner = static_cast<int>(symbolMm / texelMm);
    const int margin = (outer - inner) / 2;
    std::optional<Vec2> best;
    for (int row = 0; row + outer < edge_; ++row) {
      for (int column = 0; column + outer < edge_; ++column) {
        const Vec2 middle = (Vec2(column, row) + outer / 2.0) * texelMm - map_->window.extentMm / 2;
        if (best && glm::length(middle) >= glm::length(*best)) continue;
        if (fit(column, row, outer).weight() < static_cast<double>(outer) * outer) continue;
        const double bend = fit(column + margin, row + margin, inner).rms();
        if (aimToleranceDeg(bend, symbolMm / modules) >= kForgivingTiltDeg) best = middle;
      }
    }
    return best;
  }

 private:
  std::size_t indexOf(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(edge_) + static_cast<std::size_t>(column);
  }
  PlaneFit fit(int column, int row, int size) const {
    PlaneFit fit = sums_[indexOf(column + size, row + size)];
    fit -= sums_[indexOf(column, row + size)];
    fit -= sums_[indexOf(column + size, row)];
    fit += sums_[indexOf(column, row)];
    return fit;
  }

  const VisibilityMap* map_;
  int edge_;
  std::vector<PlaneFit> sums_;
};

/// Returns the surface point that a map shows at a point of its plane.
std::optional<SurfacePoint> surfaceAt(const Mesh& mesh, const VisibilityMap& map, Vec2 onPlane) {
  const ProjectionFrame& frame = map.frame;
  const int n = map.window.texels;
  const Vec2 texel = (onPlane / map.window.extentMm + 0.5) * static_cast<double>(n);
  const double height = static_cast<double>(
      map.heightMm(std::clamp(static_cast<int>(texel.x), 0, n - 1), std::clamp(static_cast<int>(texel.y), 0, n - 1)));
  const Vec2 across = onPlane * (1 - height / frame.eyeDistance);
  return closestPoint(mesh, frame.centre + frame.right * across.x + frame.up * across.y + frame.normal * height);
}

}  // namespace

bool isSteady(const CodeEstimate& code, int modules, const PlacementRequest& request, double leastMm) {
  const bool fits = request.sizeMode == SizeMode::Fixed ? code.missingFraction <= kMissing
                                                        : code.symbolMm >= std::max(leastMm, kMinModuleMm * modules);
  return fits && aimToleranceDeg(code.bendMm, code.symbolMm / modules) >= kForgivingTiltDeg;
}

Result<NearbyCentre> nearbyCentre(const EstimatedSurface& surface, const SurfacePoint& picked, int modules,
                                  const PlacementRequest& request, double leastMm, std::optional<double> expectedMm) {
  auto here = estimateCode(surface, picked, modules, request, expectedMm);
  QRELIEF_TRY(here);
  NearbyCentre result{picked, std::move(*here)};
  if (isSteady(result.estimate, modules, request, leastMm)) return result;

  const double outer = roomFactor(modules, request);
  const bool isFixed = request.sizeMode == SizeMode::Fixed;
  const double smallest = isFixed ? request.sizeMm : std::max(leastMm, kMinModuleMm * modules);
  const double largest = std::max(smallest, result.estimate.symbolMm);
  const ProjectionFrame upright =
      makeFrame(picked.position, triangleNormal(surface.mesh, picked.triangle), request.upHint, request.eyeDistanceMm);
  const MapWindow window{(1 + 2 * kReachEdges) * outer * largest + 2 * kReachMm, kTexels};
  const auto map = lookAround(surface.renderer, turned(upright, toRadians(request.rotateDeg)), window);
  QRELIEF_TRY(map);
  const SquareFits squares(*map);
  int estimates = 0;
  for (double size = largest; size >= smallest && estimates < kEstimates; size *= kNextSize) {
    const auto middle = squares.nearest(size, size * outer, modules);
    if (!middle) continue;
    if (glm::length(*middle) < kLeastMoveTexels * window.texelMm()) break;  // so do all smaller codes
    const auto centre = surfaceAt(surface.mesh, *map, *middle);
    if (!centre) break;
    ++estimates;
    auto there = estimateCode(surface, *centre, modules, request, size);
    if (!there || !isSteady(*there, modules, request, leastMm)) continue;
    if (isFixed || there->symbolMm >= kKeptSize * size) return NearbyCentre{*centre, std::move(*there)};
  }
  return result;
}

}  // namespace qrelief
