// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace qrelief {

/// Axis-aligned box of a triangle. Its corners are coordinates of the mesh, so overlap tests are exact.
struct FloatBox {
  Vec3f min, max;

  bool overlaps(const FloatBox& other) const {
    // Without branches, because no branch predictor can guess which of the six comparisons decides.
    return (min.x <= other.max.x) & (other.min.x <= max.x) & (min.y <= other.max.y) & (other.min.y <= max.y) &
           (min.z <= other.max.z) & (other.min.z <= max.z);
  }
};

FloatBox boxOfTriangle(const Mesh& mesh, const Triangle& triangle);

/// A tree over the boxes of some triangles of a mesh. The triangles are sorted along a Morton curve; four form a leaf,
/// and two neighbouring nodes form a node of the next level [Lauterbach et al. 2009, with the curve cut at fixed
/// places].
class BoxTree {
 public:
  static constexpr std::size_t kLeafSize = 4;

  /// Cost: O(n).
  /// @param triangles  no two the same
  BoxTree(const Mesh& mesh, std::span<const std::uint32_t> triangles);

  /// Makes a tree of any items that have boxes.
  /// @param items  a number for each box, no two the same; trianglesIn() returns these numbers
  BoxTree(std::span<const std::uint32_t> items, std::span<const FloatBox> boxes);

  /// Returns the box of all items; meaningful if there is a leaf.
  const FloatBox& bounds() const { return nodes_.back(); }

  std::size_t leafCount() const { return (triangles_.size() + kLeafSize - 1) / kLeafSize; }

  /// Return the triangles of a leaf, and their boxes.
  std::span<const std::uint32_t> trianglesIn(std::size_t leaf) const { return ofLeaf(triangles_, leaf); }
  std::span<const FloatBox> boxesIn(std::size_t leaf) const { return ofLeaf(boxes_, leaf); }
  const FloatBox& boxOfLeaf(std::size_t leaf) const { return nodes_[leaf]; }

  /// Finds the leaves, from `first` on, whose boxes overlap or touch the box; ascending. Cost: usually O(log n +
  /// found).
  void findLeaves(const FloatBox& box, std::size_t first, std::vector<std::uint32_t>& leaves) const;

 private:
  template <class T>
  std::span<const T> ofLeaf(const std::vector<T>& all, std::size_t leaf) const {
    return std::span(all).subspan(leaf * kLeafSize, std::min(kLeafSize, all.size() - leaf * kLeafSize));
  }

  std::vector<std::uint32_t> triangles_;  // along the curve
  std::vector<FloatBox> boxes_;           // of the triangles, in the same order
  std::vector<FloatBox> nodes_;           // level by level, leaves first, root last
  std::vector<std::size_t> levels_;       // first index of each level in nodes_, and the end
};

}  // namespace qrelief
