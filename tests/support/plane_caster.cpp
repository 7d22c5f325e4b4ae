// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/plane_caster.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qrelief {
namespace {

constexpr int kBins = 64;

auto sharedVertices(const Triangle& s, const Triangle& t) {
  return std::count_if(s.begin(), s.end(), [&](std::uint32_t v) { return v == t[0] || v == t[1] || v == t[2]; });
}

}  // namespace

PlaneCaster::PlaneCaster(const Mesh& mesh, const ProjectionFrame& frame, double halfMm)
    : mesh_(mesh), frame_(frame), half_(halfMm), bins_(kBins * kBins) {
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    Vec2 lo(std::numeric_limits<double>::infinity()), hi = -lo;
    int before = 0;
    for (int k = 0; k < 3; ++k) {
      if (frame.distanceAlongAxis(mesh.corner(t, k)) <= 1e-9 * frame.eyeDistance) continue;
      ++before;
      lo = glm::min(lo, frame.project(mesh.corner(t, k)));
      hi = glm::max(hi, frame.project(mesh.corner(t, k)));
    }
    if (before == 0) continue;
    if (before < 3) lo = Vec2(-half_), hi = Vec2(half_);  // partly behind the eye: its image may be anywhere
    if (hi.x < -half_ || hi.y < -half_ || lo.x > half_ || lo.y > half_) continue;
    for (int row = bin(lo.y); row <= bin(hi.y); ++row)
      for (int column = bin(lo.x); column <= bin(hi.x); ++column)
        bins_[static_cast<std::size_t>(row * kBins + column)].push_back(t);
  }
}

int PlaneCaster::bin(double x) const {
  return static_cast<int>(std::clamp((x / half_ + 1) / 2 * kBins, 0.0, kBins - 1.0));
}

std::optional<PlaneCaster::Hit> PlaneCaster::hit(Vec2 p) const {
  const Vec3 origin = frame_.eye(), direction = frame_.rayDirection(p);
  std::optional<Hit> first;
  for (const std::uint32_t t : bins_[static_cast<std::size_t>(bin(p.y) * kBins + bin(p.x))]) {
    const Vec3 a = mesh_.corner(t, 0), u = mesh_.corner(t, 1) - a, v = mesh_.corner(t, 2) - a, w = origin - a;
    const double determinant = -glm::dot(direction, glm::cross(u, v));
    const double sign = determinant < 0 ? -1 : 1;
    const Vec3 q = glm::cross(w, direction);
    const double beta = sign * glm::dot(v, q), gamma = -sign * glm::dot(u, q);
    const double slack = 1e-12 * std::abs(determinant);  // an edge belongs to both its triangles
    if (determinant == 0 || beta < -slack || gamma < -slack || beta + gamma > std::abs(determinant) + slack) continue;
    const double distance = glm::dot(w, glm::cross(u, v)) / determinant;
    if (distance > 0 && (!first || distance < first->distance)) first = Hit{t, distance, determinant > 0};
  }
  return first;
}

double PlaneCaster::distance(Vec2 p) const {
  const auto first = hit(p);
  return first ? first->distance : std::numeric_limits<double>::infinity();
}

bool PlaneCaster::connected(Vec2 p, const Hit& atP, Vec2 q, const Hit& atQ) const {
  const auto shared = sharedVertices(mesh_.triangles[atP.triangle], mesh_.triangles[atQ.triangle]);
  if (shared >= 2) return true;  // a single shared vertex may be a fold
  // Without a shared vertex, a facet comes through another here.
  if (glm::distance(p, q) < 1e-9 * half_) return shared == 1 && std::abs(atP.distance - atQ.distance) < 1e-4;
  const Vec2 middle = (p + q) * 0.5;
  const auto between = hit(middle);
  return between && between->front && connected(p, atP, middle, *between) && connected(middle, *between, q, atQ);
}

}  // namespace qrelief
