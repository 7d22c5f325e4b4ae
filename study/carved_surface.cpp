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
  QRELIEF_TRY(carved);
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

Hemisphere::Hemisphere(Vec3 normal, std::uint64_t seed) : normal_(normal) {
  const Vec3 aside = std::abs(normal.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  right_ = glm::normalize(glm::cross(aside, normal));
  up_ = glm::cross(normal, right_);
  Random random(seed);
  shift_.x = random.uniform();
  shift_.y = random.uniform();
}

double Hemisphere::cosine(std::size_t i) const {
  return std::fmod(halton23(static_cast<std::uint32_t>(i + 1))[0] + shift_.x, 1.0);
}

Vec3 Hemisphere::direction(std::size_t i) const {
  const double cosine = this->cosine(i), sine = std::sqrt(1 - cosine * cosine);
  const double azimuth = 2 * std::numbers::pi * (halton23(static_cast<std::uint32_t>(i + 1))[1] + shift_.y);
  return normal_ * cosine + right_ * (sine * std::cos(azimuth)) + up_ * (sine * std::sin(azimuth));
}

}  // namespace qrelief::study
