// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/shell_below.h"

#include <algorithm>

#include "math/tolerance.h"
#include "mesh/ray.h"

namespace qrelief {
namespace {

constexpr int kRaysPerEdge = 5;

/// A ray from the eye, which looks for one surface after the other.
class Descent {
 public:
  Descent(const Mesh& mesh, Vec3 eye, Vec3 direction) : mesh_(mesh), origin_(eye), direction_(direction) {}

  /// Moves to the next surface. @returns false if there is none
  bool next() {
    const auto hit = firstHit(mesh_, origin_ + direction_ * from_, direction_);
    if (!hit) return false;
    reachedMm_ = from_ + hit->distance;
    isEntry_ = glm::dot(triangleNormal(mesh_, hit->triangle), direction_) < 0;
    from_ = reachedMm_ + kOnSurfaceMm;
    return true;
  }

  double reachedMm() const { return reachedMm_; }
  bool isEntry() const { return isEntry_; }  ///< true: the surface is seen from the front

 private:
  const Mesh& mesh_;
  Vec3 origin_, direction_;
  double from_ = 0, reachedMm_ = 0;
  bool isEntry_ = false;
};

std::optional<double> shellBelow(const Mesh& mesh, Vec3 eye, Vec3 direction) {
  Descent descent(mesh, eye, direction);
  if (!descent.next() || !descent.isEntry()) return std::nullopt;
  const double surfaceMm = descent.reachedMm();
  if (!descent.next()) return std::nullopt;
  const double belowMm = descent.reachedMm() - surfaceMm;
  if (descent.isEntry()) return belowMm;
  const bool staysInside = descent.next() && !descent.isEntry();  // the shell behind begins at this far side
  return staysInside ? std::optional(belowMm) : std::nullopt;
}

}  // namespace

std::optional<double> shellBelowMm(const Mesh& mesh, const Placement& placement, double reachMm) {
  const ProjectionFrame& frame = placement.frame;
  std::optional<double> least;
  for (int k = 0; k < kRaysPerEdge * kRaysPerEdge; ++k) {
    const Vec2 cell(k % kRaysPerEdge, k / kRaysPerEdge);
    const Vec2 onPlane = ((cell + 0.5) / static_cast<double>(kRaysPerEdge) - 0.5) * placement.symbolMm;
    const auto below = shellBelow(mesh, frame.eye(), frame.rayDirection(onPlane));
    if (below && *below <= reachMm) least = std::min(*below, least.value_or(*below));
  }
  return least;
}

}  // namespace qrelief
