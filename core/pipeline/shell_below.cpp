// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/shell_below.h"

#include <algorithm>
#include <cmath>

#include "math/tolerance.h"
#include "mesh/ray.h"
#include "mesh/triangle_clusters.h"

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

/// Calls the function with the direction of each ray through the symbol.
template <class Function>
void forEachRay(const Placement& placement, Function follow) {
  for (int k = 0; k < kRaysPerEdge * kRaysPerEdge; ++k) {
    const Vec2 cell(k % kRaysPerEdge, k / kRaysPerEdge);
    const Vec2 onPlane = ((cell + 0.5) / static_cast<double>(kRaysPerEdge) - 0.5) * placement.symbolMm;
    follow(placement.frame.rayDirection(onPlane));
  }
}

}  // namespace

std::optional<double> shellBelowMm(const Mesh& mesh, const Placement& placement, double reachMm) {
  std::optional<double> least;
  forEachRay(placement, [&](Vec3 direction) {
    const auto below = shellBelow(mesh, placement.frame.eye(), direction);
    if (below && *below <= reachMm) least = std::min(*below, least.value_or(*below));
  });
  return least;
}

bool hasTwinSurface(const Mesh& mesh, const Placement& placement) {
  if (mesh.bodyOf.empty()) return false;
  const std::uint32_t carved = mesh.body(placement.seed);
  Mesh own, others;  // with all positions
  own.positions = others.positions = mesh.positions;
  const ViewPyramid seen(placement.frame, placement.symbolMm);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Box3 box;
    for (int k = 0; k < 3; ++k) box.add(mesh.corner(t, k));
    if (seen.mayMeet(box)) (mesh.body(t) == carved ? own : others).triangles.push_back(mesh.triangles[t]);
  }
  if (others.triangles.empty()) return false;
  int twins = 0;
  forEachRay(placement, [&](Vec3 direction) {
    const auto hit = firstHit(own, placement.frame.eye(), direction),
               other = firstHit(others, placement.frame.eye(), direction);
    if (hit && other && std::abs(hit->distance - other->distance) <= kOnSurfaceMm) ++twins;
  });
  return 2 * twins > kRaysPerEdge * kRaysPerEdge;
}

}  // namespace qrelief
