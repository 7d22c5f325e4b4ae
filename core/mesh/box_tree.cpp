// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/box_tree.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/parallel.h"
#include "base/radix_sort.h"

namespace qrelief {
namespace {

constexpr double kCellsPerAxis = 1 << 16;
constexpr std::size_t kBoxesAPiece = 1 << 14;  // of parallel work: some tenths of a millisecond

FloatBox united(const FloatBox& a, const FloatBox& b) { return {glm::min(a.min, b.min), glm::max(a.max, b.max)}; }

/// Returns the bits of a 16-bit number with two zeros between neighbours.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 16) & 0x0000'ff00'00ffu;
  bits = (bits | bits << 8) & 0xf'00f0'0f00'f00fu;
  bits = (bits | bits << 4) & 0xc3'0c30'c30c'30c3u;
  return (bits | bits << 2) & 0x249'2492'4924'9249u;
}

/// Sorts boxes by the place of their centres on the curve. The order affects only the tree's speed.
std::vector<KeyedIndex> alongCurve(std::span<const FloatBox> boxes) {
  Box3 centres;
  for (const FloatBox& box : boxes) centres.add(Vec3(box.min) + Vec3(box.max));
  const Vec3 size = glm::max(centres.size(), Vec3(1e-300));
  const double scale = (kCellsPerAxis - 1) / std::max({size.x, size.y, size.z});
  std::vector<KeyedIndex> order(boxes.size());
  parallelForPieces(boxes.size(), kBoxesAPiece, [&](std::size_t i) {
    const Vec3 cell = (Vec3(boxes[i].min) + Vec3(boxes[i].max) - centres.min) * scale;
    order[i] = {spread(static_cast<std::uint64_t>(cell.x)) | spread(static_cast<std::uint64_t>(cell.y)) << 1 |
                    spread(static_cast<std::uint64_t>(cell.z)) << 2,
                static_cast<std::uint32_t>(i)};
  });
  radixSort(order);
  return order;
}

std::vector<FloatBox> boxesOf(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
  std::vector<FloatBox> boxes(triangles.size());
  parallelForPieces(boxes.size(), kBoxesAPiece,
                    [&](std::size_t i) { boxes[i] = boxOfTriangle(mesh, mesh.triangles[triangles[i]]); });
  return boxes;
}

}  // namespace

FloatBox boxOfTriangle(const Mesh& mesh, const Triangle& t) {
  const Vec3f a = mesh.positions[t[0]];
  const Vec3f b = mesh.positions[t[1]];
  const Vec3f c = mesh.positions[t[2]];
  return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

BoxTree::BoxTree(const Mesh& mesh, std::span<const std::uint32_t> triangles)
    : BoxTree(triangles, boxesOf(mesh, triangles)) {}

BoxTree::BoxTree(std::span<const std::uint32_t> items, std::span<const FloatBox> boxes) {
  triangles_.resize(items.size());
  boxes_.resize(items.size());
  const std::vector<KeyedIndex> order = alongCurve(boxes);
  parallelForPieces(items.size(), kBoxesAPiece, [&](std::size_t i) {
    triangles_[i] = items[order[i].index];
    boxes_[i] = boxes[order[i].index];
  });

  nodes_.reserve(2 * leafCount() + 32);  // every level has half the nodes of the one below, rounded up
  nodes_.resize(leafCount());
  parallelForPieces(leafCount(), kBoxesAPiece, [&](std::size_t leaf) {
    const auto inLeaf = boxesIn(leaf);
    nodes_[leaf] = inLeaf[0];
    for (const FloatBox& box : inLeaf) nodes_[leaf] = united(nodes_[leaf], box);
  });
  levels_ = {0, nodes_.size()};
  while (levels_.back() - levels_[levels_.size() - 2] > 1) {
    const std::size_t end = levels_.back();
    for (std::size_t i = levels_[levels_.size() - 2]; i < end; i += 2)
      nodes_.push_back(united(nodes_[i], nodes_[std::min(i + 1, end - 1)]));
    levels_.push_back(nodes_.size());
  }
}

void BoxTree::findLeaves(const FloatBox& box, std::size_t first, std::vector<std::uint32_t>& leaves) const {
  leaves.clear();
  if (leafCount() == 0 || !bounds().overlaps(box)) return;
  // The tree has at most 32 levels, and one node waits on each.
  std::array<std::pair<std::size_t, std::size_t>, 64> waiting;
  std::size_t count = 0;
  waiting[count++] = {levels_.size() - 2, 0};
  while (count > 0) {
    const auto [level, index] = waiting[--count];
    if (level == 0) {
      leaves.push_back(static_cast<std::uint32_t>(index));
      continue;
    }
    const std::size_t below = level - 1;
    const std::size_t size = levels_[level] - levels_[below];
    for (const std::size_t child : {2 * index + 1, 2 * index})
      if (child < size && (child + 1) << below > first && nodes_[levels_[below] + child].overlaps(box))
        waiting[count++] = {below, child};
  }
}

}  // namespace qrelief
