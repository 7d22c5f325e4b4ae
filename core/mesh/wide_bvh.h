// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "mesh/bvh.h"

namespace qrelief {

/// A tree for many rays whose nodes have four children. The four boxes are tested at once, with one instruction for
/// each step of the test [Dammertz, Hanika, Keller 2008].
///
/// The test uses 32-bit numbers that err on the safe side: it skips no leaf whose box a ray meets, but may visit a leaf
/// whose box the ray only just misses.
class WideBvh {
 public:
  /// Cost: O(nodes).
  explicit WideBvh(const Bvh& tree);

  /// Visits the leaves whose boxes a ray meets between `from` and `nearest`, both in units of the direction's length;
  /// usually nearer ones first.
  /// @param nearest  read again after each leaf
  /// @param leaf     (begin, end) in the order of the tree
  template <class Leaf>
  void visit(Vec3 origin, Vec3 direction, double from, const double& nearest, const Leaf& leaf) const;

 private:
  using Four = float __attribute__((vector_size(16)));

  /// A node. Unused children have boxes that no ray meets.
  struct Node {
    std::array<Four, 3> min, max;
    std::array<std::uint32_t, 4> begin;  ///< leaf: see Bvh::Node; else the child's index
    std::array<std::uint32_t, 4> count;  ///< items of a leaf; 0 = inner node
  };

  /// A ray prepared for the test, with margins for rounding.
  struct Ray {
    std::array<Four, 3> above, below;  // floats next to the origin's coordinates
    std::array<Four, 3> inverse;
    std::array<bool, 3> isBackward;
  };
  static constexpr float kRounding = 1e-6f;   // of a difference times an inverse: 3 units in the last place
  static constexpr std::size_t kStack = 512;  // at most three nodes per level wait; Bvh bounds the levels

  static Ray rayOf(Vec3 origin, Vec3 direction);
  static Four smaller(Four a, Four b) { return a < b ? a : b; }
  static Four larger(Four a, Four b) { return a > b ? a : b; }
  static Four all(float value) { return Four{value, value, value, value}; }

  std::uint32_t add(const Bvh& tree, std::uint32_t index);

  std::vector<Node> nodes_;
};

template <class Leaf>
void WideBvh::visit(Vec3 origin, Vec3 direction, double from, const double& nearest, const Leaf& leaf) const {
  if (nodes_.empty()) return;
  struct Waiting {
    float enter;
    std::uint32_t begin, count;
  };
  const Ray ray = rayOf(origin, direction);
  const Four begin = all(static_cast<float>(from) * (1 - kRounding));
  std::array<Waiting, kStack> waiting;
  std::size_t depth = 0;
  waiting[depth++] = {0, 0, 0};
  while (depth > 0) {
    const Waiting next = waiting[--depth];
    const float farthest = static_cast<float>(nearest) * (1 + kRounding);
    if (next.enter > farthest) continue;
    if (next.count > 0) {
      leaf(next.begin, next.begin + next.count);
      continue;
    }
    const Node& node = nodes_[next.begin];
    Four enter = begin, leave = all(std::numeric_limits<float>::infinity());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Four low = (node.min[axis] - ray.above[axis]) * ray.inverse[axis];
      const Four high = (node.max[axis] - ray.below[axis]) * ray.inverse[axis];
      // NaN (the ray runs along a side of the box) leaves the bounds unchanged.
      enter = larger((ray.isBackward[axis] ? high : low) * (1 - kRounding), enter);
      leave = smaller((ray.isBackward[axis] ? low : high) * (1 + kRounding), leave);
    }
    const auto meets = (enter <= leave) & (enter <= all(farthest));
    const std::size_t first = depth;
    for (std::size_t child = 0; child < 4; ++child) {
      if (!meets[child]) continue;
      std::size_t at = depth++;  // the nearest is visited first, so it goes last
      for (; at > first && waiting[at - 1].enter < enter[child]; --at) waiting[at] = waiting[at - 1];
      waiting[at] = {enter[child], node.begin[child], node.count[child]};
    }
  }
}

}  // namespace qrelief
