// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/facet_tree.h"

#include <algorithm>
#include <cmath>

namespace qrelief {
namespace {

constexpr std::uint32_t kLeafFacets = 4;

double squaredDistance(Vec3 p, const Box3& box) {
  const Vec3 away = glm::max(glm::max(box.min - p, p - box.max), Vec3(0));
  return glm::dot(away, away);
}

double squaredDistanceToSegment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 along = b - a;
  const double squared = glm::dot(along, along);
  const double fraction = squared > 0 ? std::clamp(glm::dot(p - a, along) / squared, 0.0, 1.0) : 0;
  const Vec3 away = p - a - along * fraction;
  return glm::dot(away, away);
}

/// To the plane where the foot of the perpendicular lies in the facet, else to the nearest side.
double squaredDistance(Vec3 p, const FacetTree::Facet& facet) {
  const Vec3 normal = glm::cross(facet[1] - facet[0], facet[2] - facet[0]);
  const double area = glm::dot(normal, normal);
  bool above = area > 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 a = facet[k];
    const Vec3 b = facet[(k + 1) % 3];
    above = above && glm::dot(glm::cross(normal, b - a), p - a) >= 0;
    least = std::min(least, squaredDistanceToSegment(p, a, b));
  }
  if (!above) return least;
  const double height = glm::dot(normal, p - facet[0]);
  return height * height / area;
}

/// Unit; zero without area.
Vec3 normalOf(const FacetTree::Facet& facet) {
  const Vec3 normal = glm::cross(facet[1] - facet[0], facet[2] - facet[0]);
  const double length = glm::length(normal);
  return length > 0 ? normal / length : Vec3(0);
}

Vec3 middle(const FacetTree::Facet& facet) { return (facet[0] + facet[1] + facet[2]) / 3.0; }

}  // namespace

FacetTree::FacetTree(std::vector<Facet> facets) : facets_(std::move(facets)) {
  if (!facets_.empty()) build(0, static_cast<std::uint32_t>(facets_.size()));
}

std::uint32_t FacetTree::build(std::uint32_t begin, std::uint32_t end) {
  const std::uint32_t index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Box3 box;
  Box3 middles, normals;
  for (std::uint32_t k = begin; k < end; ++k) {
    for (const Vec3 corner : facets_[k]) box.add(corner);
    middles.add(middle(facets_[k]));
    normals.add(normalOf(facets_[k]));
  }
  nodes_[index].box = box;
  nodes_[index].normals = normals;
  if (end - begin <= kLeafFacets) {
    nodes_[index].begin = begin;
    nodes_[index].end = end;
    return index;
  }
  const Vec3 size = middles.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  const std::uint32_t half = begin + (end - begin) / 2;
  std::nth_element(facets_.begin() + begin, facets_.begin() + half, facets_.begin() + end,
                   [axis](const Facet& a, const Facet& b) { return middle(a)[axis] < middle(b)[axis]; });
  build(begin, half);
  const std::uint32_t right = build(half, end);
  nodes_[index].right = right;
  return index;
}

template <class NodeCounts, class FacetCounts>
double FacetTree::nearest(Vec3 point, double reach, const NodeCounts& nodeCounts,
                          const FacetCounts& facetCounts) const {
  if (nodes_.empty()) return reach;
  double least = reach * reach;
  std::array<std::uint32_t, 64> stack;  // halving 2^32 facets down to kLeafFacets takes fewer levels
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const Node& node = nodes_[index];
    if (!nodeCounts(node) || squaredDistance(point, node.box) >= least) continue;
    if (node.begin < node.end) {
      for (std::uint32_t k = node.begin; k < node.end; ++k)
        if (facetCounts(facets_[k])) least = std::min(least, squaredDistance(point, facets_[k]));
      continue;
    }
    std::uint32_t near = index + 1;
    std::uint32_t far = node.right;
    if (squaredDistance(point, nodes_[far].box) < squaredDistance(point, nodes_[near].box)) std::swap(near, far);
    stack[depth++] = far;
    stack[depth++] = near;
  }
  return std::sqrt(least);
}

double FacetTree::distance(Vec3 point, double reach) const {
  const auto any = [](const auto&) { return true; };
  return nearest(point, reach, any, any);
}

double FacetTree::distanceOfTurned(Vec3 point, double reach, Vec3 normal, double component) const {
  const auto mayTurn = [&](const Node& node) {
    const Vec3 least = glm::min(normal * node.normals.min, normal * node.normals.max);
    return least.x + least.y + least.z < component;
  };
  const auto turns = [&](const Facet& facet) { return glm::dot(normalOf(facet), normal) < component; };
  return nearest(point, reach, mayTurn, turns);
}

}  // namespace qrelief
