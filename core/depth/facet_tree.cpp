// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth/facet_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qrelief {
namespace {

double squaredDistance(Vec3 p, const Bvh::Box& box) {
  const Vec3 away = glm::max(glm::max(Vec3(box.min) - p, p - Vec3(box.max)), Vec3(0));
  return glm::dot(away, away);
}

double squaredDistanceToSegment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 along = b - a;
  const double squared = glm::dot(along, along);
  const double fraction = squared > 0 ? std::clamp(glm::dot(p - a, along) / squared, 0.0, 1.0) : 0;
  const Vec3 away = p - a - along * fraction;
  return glm::dot(away, away);
}

/// Returns the squared distance to the plane if the foot of the perpendicular lies in the facet, else to the nearest of
/// the sides that it lies beyond. A facet without area has three such sides.
double squaredDistance(Vec3 p, const FacetTree::Facet& facet) {
  const Vec3 normal = glm::cross(facet[1] - facet[0], facet[2] - facet[0]);
  const double area = glm::dot(normal, normal);
  bool above = true;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 a = facet[k];
    const Vec3 b = facet[(k + 1) % 3];
    if (area > 0 && glm::dot(glm::cross(normal, b - a), p - a) >= 0) continue;
    above = false;
    least = std::min(least, squaredDistanceToSegment(p, a, b));
  }
  if (!above) return least;
  const double height = glm::dot(normal, p - facet[0]);
  return height * height / area;
}

/// Returns the unit normal; zero for a facet without area.
Vec3 normalOf(const FacetTree::Facet& facet) {
  const Vec3 normal = glm::cross(facet[1] - facet[0], facet[2] - facet[0]);
  const double length = glm::length(normal);
  return length > 0 ? normal / length : Vec3(0);
}

/// Returns boxes that enclose the facets, although 32-bit floats may not represent their corners exactly.
std::vector<Bvh::Box> boxesOf(std::span<const FacetTree::Facet> facets) {
  constexpr float kFarthest = std::numeric_limits<float>::infinity();
  std::vector<Bvh::Box> boxes;
  boxes.reserve(facets.size());
  for (const FacetTree::Facet& facet : facets) {
    const Vec3 min = glm::min(facet[0], glm::min(facet[1], facet[2]));
    const Vec3 max = glm::max(facet[0], glm::max(facet[1], facet[2]));
    Bvh::Box box{Vec3f(min), Vec3f(max)};
    for (int axis = 0; axis < 3; ++axis) {
      if (static_cast<double>(box.min[axis]) > min[axis]) box.min[axis] = std::nextafter(box.min[axis], -kFarthest);
      if (static_cast<double>(box.max[axis]) < max[axis]) box.max[axis] = std::nextafter(box.max[axis], kFarthest);
    }
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace

FacetTree::FacetTree(std::span<const Facet> facets) : tree_(boxesOf(facets)), normals_(tree_.nodes().size()) {
  facets_.reserve(facets.size());
  for (const std::uint32_t i : tree_.order()) facets_.push_back(facets[i]);
  for (std::size_t i = normals_.size(); i-- > 0;) {  // children before their parents
    const Bvh::Node& node = tree_.nodes()[i];
    for (std::uint32_t k = 0; k < node.count; ++k) normals_[i].add(normalOf(facets_[node.begin + k]));
    if (node.count > 0) continue;
    for (const std::size_t child : {i + 1, std::size_t{node.begin}}) {
      normals_[i].add(normals_[child].min);
      normals_[i].add(normals_[child].max);
    }
  }
}

template <class NodeCounts, class FacetCounts>
double FacetTree::nearest(Vec3 point, double reach, Hint& hint, const NodeCounts& nodeCounts,
                          const FacetCounts& facetCounts) const {
  if (facets_.empty()) return reach;
  const std::span nodes = tree_.nodes();
  double least = reach * reach;
  const auto measureFacet = [&](std::uint32_t k) {
    if (!facetCounts(facets_[k])) return;
    const double squared = squaredDistance(point, facets_[k]);
    if (squared >= least) return;
    least = squared;
    hint.facet = k;
  };
  measureFacet(hint.facet);
  const auto isNear = [&](std::uint32_t node) {
    return nodeCounts(node) && squaredDistance(point, nodes[node].box) < least;
  };
  const auto firstIsNearer = [&](std::uint32_t first, std::uint32_t second) {
    return squaredDistance(point, nodes[first].box) <= squaredDistance(point, nodes[second].box);
  };
  const auto measure = [&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t k = begin; k < end; ++k) measureFacet(k);
  };
  tree_.visit(isNear, firstIsNearer, measure);
  return std::sqrt(least);
}

double FacetTree::distance(Vec3 point, double reach, Hint& hint) const {
  const auto any = [](const auto&) { return true; };
  return nearest(point, reach, hint, any, any);
}

double FacetTree::distanceOfTurned(Vec3 point, double reach, Vec3 normal, double component, Hint& hint) const {
  const auto mayTurn = [&](std::uint32_t node) {
    const Vec3 least = glm::min(normal * normals_[node].min, normal * normals_[node].max);
    return least.x + least.y + least.z < component;
  };
  const auto turns = [&](const Facet& facet) { return glm::dot(normalOf(facet), normal) < component; };
  return nearest(point, reach, hint, mayTurn, turns);
}

}  // namespace qrelief
