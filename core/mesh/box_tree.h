// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/mesh.h"

namespace qrelief {

/// Axis-aligned box of a triangle; its corners are coordinates of the mesh, so overlap is decided exactly.
struct FloatBox {
  Vec3f min, max;

  bool overlaps(const FloatBox& other) const {
    return min.x <= other.max.x && other.min.x <= max.x && min.y <= other.max.y && other.min.y <= max.y &&
           min.z <= other.max.z && other.min.z <= max.z;
  }
};

/// A tree over the boxes of a mesh's triangles: halved along the longest axis of their centres, ties by index.
class BoxTree {
 public:
  /// Cost: O(T log T).
  explicit BoxTree(const Mesh& mesh);

  const FloatBox& boxOf(std::uint32_t triangle) const { return boxes_[triangle]; }

  /// Triangles whose boxes overlap (or touch) the box, ascending. Cost: O(log T + found) as a rule.
  void findOverlaps(const FloatBox& box, std::vector<std::uint32_t>& found) const;

 private:
  struct Node {
    FloatBox box;
    std::uint32_t begin, end;  ///< range of order_
    std::uint32_t second;      ///< the other child; the first is the next node. 0 for a leaf
  };

  std::uint32_t build(std::uint32_t begin, std::uint32_t end);

  std::vector<FloatBox> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace qrelief
