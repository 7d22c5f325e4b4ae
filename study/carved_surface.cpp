// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/carved_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/halton.h"
#include "base/random.h"
#include "carving/embed.h"

namespace qrelief::study {

Result<CarvedSurface> CarvedSurface::make(const StudyPlacement& spot, const DepthField& depths) {
  auto carved =
      embedDepthField(spot.model->prepared.mesh, spot.placement.frame, spot.placement.patch.triangles, depths);
  if (!carved) return tl::unexpected(carved.error());
  CarvedSurface surface;
  surface.mesh_ = std::make_unique<Mesh>(std::move(carved->mesh));
  surface.tree_ = std::make_unique<RayTree>(*surface.mesh_);
  surface.frame_ = spot.placement.frame;
  surface.depths_ = {depths.size, depths.symbolMm, {}};
  return surface;
}

std::optional<SurfacePoint> CarvedSurface::pointOf(std::uint32_t submodule, Vec2 place) const {
  const int row = static_cast<int>(submodule) / depths_.size, column = static_cast<int>(submodule) % depths_.size;
  const Vec2 at = depths_.corner(row, column) + Vec2(place.x, -place.y) * depths_.submoduleMm();
  return tree_->firstHit(frame_.eye(), frame_.rayDirection(at));
}

Vec3 CarvedSurface::normalAt(const SurfacePoint& at) const {
  const Vec3 normal = tree_->normalAt(at);
  return glm::dot(normal, frame_.eye() - at.position) < 0 ? -normal : normal;
}

void overHemisphere(const CarvedSurface& surface, const SurfacePoint& at, int rays, std::uint64_t seed,
                    const std::function<void(double, const std::optional<double>&)>& tell) {
  const Vec3 normal = surface.normalAt(at);
  const Vec3 aside = std::abs(normal.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  const Vec3 right = glm::normalize(glm::cross(aside, normal)), up = glm::cross(normal, right);
  Random random(seed);
  const double shift[] = {random.uniform(), random.uniform()};
  for (int i = 1; i <= rays; ++i) {
    const auto point = halton23(static_cast<std::uint32_t>(i));
    const double cosine = std::fmod(point[0] + shift[0], 1.0), sine = std::sqrt(1 - cosine * cosine);
    const double azimuth = 2 * std::numbers::pi * (point[1] + shift[1]);
    const Vec3 to = normal * cosine + right * (sine * std::cos(azimuth)) + up * (sine * std::sin(azimuth));
    tell(cosine, surface.distanceMm(at, to));
  }
}

SkySeen skySeen(const CarvedSurface& surface, const SurfacePoint& at, int rays, std::uint64_t seed) {
  SkySeen seen;
  overHemisphere(surface, at, rays, seed, [&](double cosine, const std::optional<double>& metMm) {
    if (metMm) return;
    seen.cosineWeighted += 2 * cosine / rays;
    seen.solidAngle += 2 * std::numbers::pi / rays;
  });
  return seen;
}

}  // namespace qrelief::study
