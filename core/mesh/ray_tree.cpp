// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/ray_tree.h"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "mesh/sheared_ray.h"

namespace qrelief {
namespace {

/// Part of the ray that lies in the box, widened by what rounding may cost [Ize 2013].
bool meetsBox(const Bvh::Box& box, Vec3 origin, Vec3 inverse, double nearest, double farthest) {
  for (int axis = 0; axis < 3; ++axis) {
    double enter = (static_cast<double>(box.min[axis]) - origin[axis]) * inverse[axis];
    double leave = (static_cast<double>(box.max[axis]) - origin[axis]) * inverse[axis];
    if (enter > leave) std::swap(enter, leave);
    // NaN (the origin lies on a side that the ray runs along) leaves the bounds as they are.
    if (enter > nearest) nearest = enter;
    if (leave < farthest) farthest = leave;
  }
  return nearest <= farthest * (1 + 4 * std::numeric_limits<double>::epsilon());
}

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

RayTree::RayTree(const Mesh& mesh) : mesh_(&mesh), tree_(boxesOf(mesh)) {}

std::optional<SurfacePoint> RayTree::firstHit(Vec3 origin, Vec3 direction, double from) const {
  const ShearedRay ray(origin, direction);
  const Vec3 inverse = 1.0 / direction;
  const std::span nodes = tree_.nodes();
  const std::span order = tree_.order();
  double nearest = std::numeric_limits<double>::infinity();
  std::uint32_t found = 0;
  const auto isMet = [&](std::uint32_t node) { return meetsBox(nodes[node].box, origin, inverse, from, nearest); };
  const auto firstIsNearer = [&](std::uint32_t first, std::uint32_t second) {
    // Along the axis on which their middles are farthest apart.
    const Bvh::Box &a = nodes[first].box, &b = nodes[second].box;
    return glm::dot(Vec3(b.min + b.max) - Vec3(a.min + a.max), direction) > 0;
  };
  const auto meet = [&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t t = order[i];
      const double parameter =
          hitParameter(ray.apply(mesh_->corner(t, 0)), ray.apply(mesh_->corner(t, 1)), ray.apply(mesh_->corner(t, 2)));
      if (parameter <= from || parameter < 0) continue;
      if (parameter < nearest || (parameter == nearest && t < found)) {
        nearest = parameter;
        found = t;
      }
    }
  };
  tree_.visit(isMet, firstIsNearer, meet);
  if (!(nearest < std::numeric_limits<double>::infinity())) return std::nullopt;
  return SurfacePoint{origin + direction * nearest, found, nearest * glm::length(direction)};
}

}  // namespace qrelief
