// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/box_tree.h"

#include <algorithm>

namespace qrelief {
namespace {

constexpr std::uint32_t kLeafSize = 4;

FloatBox united(const FloatBox& a, const FloatBox& b) { return {glm::min(a.min, b.min), glm::max(a.max, b.max)}; }

}  // namespace

BoxTree::BoxTree(const Mesh& mesh) {
  boxes_.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Vec3f a = mesh.positions[t[0]];
    const Vec3f b = mesh.positions[t[1]];
    const Vec3f c = mesh.positions[t[2]];
    boxes_.push_back({glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))});
  }
  order_.resize(boxes_.size());
  for (std::uint32_t t = 0; t < order_.size(); ++t) order_[t] = t;
  nodes_.reserve(2 * order_.size() / kLeafSize + 1);
  if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
}

std::uint32_t BoxTree::build(std::uint32_t begin, std::uint32_t end) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  FloatBox box = boxes_[order_[begin]];
  const auto twiceCentre = [&](std::uint32_t t) { return boxes_[t].min + boxes_[t].max; };
  FloatBox centres{twiceCentre(order_[begin]), twiceCentre(order_[begin])};
  for (std::uint32_t i = begin + 1; i < end; ++i) {
    box = united(box, boxes_[order_[i]]);
    centres = united(centres, {twiceCentre(order_[i]), twiceCentre(order_[i])});
  }
  nodes_.push_back({box, begin, end, 0});
  if (end - begin <= kLeafSize) return index;
  const Vec3f size = centres.max - centres.min;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const float x = twiceCentre(a)[axis];
                     const float y = twiceCentre(b)[axis];
                     return x != y ? x < y : a < b;
                   });
  build(begin, middle);
  const std::uint32_t second = build(middle, end);
  nodes_[index].second = second;
  return index;
}

void BoxTree::findOverlaps(const FloatBox& box, std::vector<std::uint32_t>& found) const {
  found.clear();
  if (nodes_.empty()) return;
  // Halving keeps the tree at most 32 deep; one node waits on each level.
  std::array<std::uint32_t, 64> waiting;
  std::size_t count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const std::uint32_t index = waiting[--count];
    const Node& node = nodes_[index];
    if (!node.box.overlaps(box)) continue;
    if (node.second != 0) {
      waiting[count++] = node.second;
      waiting[count++] = index + 1;
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i)
      if (boxes_[order_[i]].overlaps(box)) found.push_back(order_[i]);
  }
  std::sort(found.begin(), found.end());
}

}  // namespace qrelief
