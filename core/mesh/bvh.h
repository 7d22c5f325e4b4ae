// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "math/vec.h"

namespace qrelief {

/// A bounding volume hierarchy over boxes, split by the surface area heuristic [Goldsmith, Salmon 1987; binned, Wald
/// 2007]. The caller defines the query: rays and distances walk the same tree.
class Bvh {
 public:
  struct Box {
    Vec3f min, max;
  };

  struct Node {
    Box box;
    std::uint32_t
        begin;  ///< leaf: index of its first item in `order`; else the second child (the first is the next node)
    std::uint32_t count;  ///< items of a leaf; 0 = inner node
  };

  /// Cost: O(n log n).
  explicit Bvh(std::span<const Box> boxes);

  /// Returns the nodes: the root first, every parent before its children. Empty if there are no boxes.
  std::span<const Node> nodes() const { return nodes_; }

  /// Returns the indices of the boxes, leaf after leaf.
  std::span<const std::uint32_t> order() const { return order_; }

  /// Visits the leaves, skipping every subtree whose root does not count.
  /// @param counts         (index of a node) → true to descend; called when the node's turn comes
  /// @param firstIsNearer  (indices of two children) → true to visit the first one first
  /// @param leaf           (begin, end) in `order`
  template <class Counts, class FirstIsNearer, class Leaf>
  void visit(const Counts& counts, const FirstIsNearer& firstIsNearer, const Leaf& leaf) const {
    if (nodes_.empty()) return;
    std::array<std::uint32_t, kMaxLevel + 2> waiting;
    std::size_t depth = 0;
    waiting[depth++] = 0;
    while (depth > 0) {
      const std::uint32_t index = waiting[--depth];
      if (!counts(index)) continue;
      const Node& node = nodes_[index];
      if (node.count > 0) {
        leaf(node.begin, node.begin + node.count);
        continue;
      }
      std::uint32_t near = index + 1, far = node.begin;
      if (!firstIsNearer(near, far)) std::swap(near, far);
      waiting[depth++] = far;
      waiting[depth++] = near;
    }
  }

 private:
  static constexpr int kMaxLevel = 100;  // bounds the stack of a query

  std::uint32_t build(std::uint32_t begin, std::uint32_t end, int level, const std::vector<Vec3f>& twiceCentres,
                      std::span<const Box> boxes);

  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace qrelief
