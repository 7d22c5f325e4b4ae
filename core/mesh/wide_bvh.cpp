// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/wide_bvh.h"

#include <algorithm>

namespace qrelief {
namespace {

double halfArea(const Bvh::Box& box) {
  const Vec3 size = Vec3(box.max) - Vec3(box.min);
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

}  // namespace

WideBvh::WideBvh(const Bvh& tree) {
  if (tree.nodes().empty()) return;
  nodes_.reserve(tree.nodes().size() / 3 + 1);
  add(tree, 0);
}

/// Replaces inner nodes by their children, the largest first, as long as there is room.
std::uint32_t WideBvh::add(const Bvh& tree, std::uint32_t index) {
  std::vector<std::uint32_t> children = {index};
  while (children.size() < 4) {
    auto largest = children.end();
    for (auto child = children.begin(); child != children.end(); ++child) {
      if (tree.nodes()[*child].count > 0) continue;
      if (largest == children.end() || halfArea(tree.nodes()[*child].box) > halfArea(tree.nodes()[*largest].box))
        largest = child;
    }
    if (largest == children.end()) break;
    const std::uint32_t parent = *largest;
    *largest = parent + 1;
    children.push_back(tree.nodes()[parent].begin);
  }

  const auto place = static_cast<std::uint32_t>(nodes_.size());
  Node node;
  node.min.fill(all(std::numeric_limits<float>::infinity()));
  node.max.fill(all(-std::numeric_limits<float>::infinity()));
  node.begin = node.count = {};
  nodes_.push_back(node);
  for (std::size_t i = 0; i < children.size(); ++i) {
    const Bvh::Node& child = tree.nodes()[children[i]];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      node.min[axis][i] = child.box.min[static_cast<int>(axis)];
      node.max[axis][i] = child.box.max[static_cast<int>(axis)];
    }
    node.begin[i] = child.count > 0 ? child.begin : add(tree, children[i]);
    node.count[i] = child.count;
  }
  nodes_[place] = node;
  return place;
}

WideBvh::Ray WideBvh::rayOf(Vec3 origin, Vec3 direction) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Ray ray;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<float>(origin[static_cast<int>(axis)]);
    const auto inverse = static_cast<float>(1 / direction[static_cast<int>(axis)]);
    ray.above[axis] = all(std::nextafter(at, kInfinity));
    ray.below[axis] = all(std::nextafter(at, -kInfinity));
    ray.inverse[axis] = all(inverse);
    ray.isBackward[axis] = inverse < 0;
  }
  return ray;
}

}  // namespace qrelief
