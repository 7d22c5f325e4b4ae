// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/ray_tree.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "mesh/sheared_ray.h"

namespace qrelief {
namespace {

std::vector<Bvh::Box> boxesOf(const Mesh& mesh) {
  std::vector<Bvh::Box> boxes;
  boxes.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Vec3f a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    boxes.push_back({glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))});
  }
  return boxes;
}

}  // namespace

RayTree::RayTree(const Mesh& mesh) : RayTree(mesh, Bvh(boxesOf(mesh))) {}

RayTree::RayTree(const Mesh& mesh, const Bvh& tree)
    : mesh_(&mesh), order_(tree.order().begin(), tree.order().end()), tree_(tree) {}

std::optional<SurfacePoint> RayTree::firstHit(Vec3 origin, Vec3 direction, double from) const {
  const ShearedRay ray(origin, direction);
  double nearest = std::numeric_limits<double>::infinity();
  std::uint32_t hit = 0;
  tree_.visit(origin, direction, from, nearest, [&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t t = order_[i];
      const double parameter =
          hitParameter(ray.apply(mesh_->corner(t, 0)), ray.apply(mesh_->corner(t, 1)), ray.apply(mesh_->corner(t, 2)));
      if (parameter <= from || parameter < 0) continue;
      if (parameter < nearest || (parameter == nearest && t < hit)) {
        nearest = parameter;
        hit = t;
      }
    }
  });
  if (!(nearest < std::numeric_limits<double>::infinity())) return std::nullopt;
  return SurfacePoint{origin + direction * nearest, hit, nearest * glm::length(direction)};
}

}  // namespace qrelief
