// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/triangulate_polygon.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>

#include "math/tolerance.h"

namespace qrelief {
namespace {

/// Number of nodes and corners that ear clipping looks at before it gives up. A spiral of a million corners takes 530
/// per corner; only a million spikes on one spot take more. The second pair applies once an outline has turned out not
/// to be simple.
constexpr std::size_t kMinTests = 100'000'000, kTestsPerCorner = 1000;
constexpr std::size_t kMinCrossedTests = 1'000'000, kTestsPerCrossedCorner = 50;

/// Number of corners above which ear clipping makes the shortest cuts first: see EarClipper::Look.
constexpr std::size_t kLargeOutline = 1000;

Vec3 newellNormal(std::span<const Vec3> corners) {
  // Relative to the first corner; otherwise cancellation would lose the area of far-away polygons.
  Vec3 sum(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return sum;
}

/// Returns the polygon in its plane, counter-clockwise.
std::vector<Vec2> flattened(std::span<const Vec3> corners, Vec3 normal) {
  const Vec3 axis = std::abs(normal.x) <= std::abs(normal.y) && std::abs(normal.x) <= std::abs(normal.z) ? Vec3(1, 0, 0)
                    : std::abs(normal.y) <= std::abs(normal.z)                                           ? Vec3(0, 1, 0)
                                                               : Vec3(0, 0, 1);
  const Vec3 u = glm::normalize(glm::cross(axis, normal));
  const Vec3 v = glm::cross(normal, u);
  std::vector<Vec2> flat;
  flat.reserve(corners.size());
  for (const Vec3& p : corners) flat.emplace_back(glm::dot(p - corners[0], u), glm::dot(p - corners[0], v));
  return flat;
}

/// Returns true for a left turn at b whose sine is more than `straightSine`.
bool turnsLeft(Vec2 a, Vec2 b, Vec2 c, double straightSine = kStraightSine) {
  return cross2(b - a, c - b) > straightSine * glm::length(b - a) * glm::length(c - b);
}

/// Returns true if all triangles of the fan about corner `apex` have area and the right sense. Such triangles cover a
/// simple outline once: a map of the disc that nowhere folds is one-to-one if it is so on the boundary.
bool fanIsValid(std::span<const Vec2> flat, std::size_t apex) {
  const std::size_t n = flat.size();
  for (std::size_t i = 1; i + 1 < n; ++i)
    if (!turnsLeft(flat[apex], flat[(apex + i) % n], flat[(apex + i + 1) % n])) return false;
  return true;
}

void appendFan(std::span<const std::uint32_t> outline, std::size_t apex,
               std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const std::size_t n = outline.size();
  for (std::size_t i = 1; i + 1 < n; ++i)
    triangles.push_back({outline[apex], outline[(apex + i) % n], outline[(apex + i + 1) % n]});
}

/// Returns true if p lies inside the counter-clockwise triangle or on its border, but not on a corner.
bool blocks(Vec2 p, Vec2 a, Vec2 b, Vec2 c) {
  if (p == a || p == b || p == c) return false;
  return cross2(b - a, p - a) >= 0 && cross2(c - b, p - b) >= 0 && cross2(a - c, p - c) >= 0;
}

/// The reflex corners of an outline in a tree of boxes. A node is halved at the outline's middle or across its box,
/// whichever gives the smaller boxes: the first suits long thin spikes side by side, the second everything else. Each
/// node counts its remaining corners.
class ReflexTree {
 public:
  ReflexTree(std::span<const Vec2> flat, std::vector<std::uint32_t> reflex) : flat_(flat), order_(std::move(reflex)) {
    if (order_.empty()) return;
    leafOf_.assign(flat.size(), 0);
    std::size_t leaves = 1;
    while (leaves * kLeafSize < order_.size()) leaves *= 2;
    nodes_.resize(2 * leaves);
    build(1, 0, order_.size());
  }

  void remove(std::uint32_t corner) {
    if (leafOf_.empty() || leafOf_[corner] == 0) return;
    for (std::size_t node = std::exchange(leafOf_[corner], 0); node > 0; node /= 2) --nodes_[node].left;
  }

  /// Returns true if a remaining reflex corner lies in the counter-clockwise triangle or on its border.
  /// @param tests  grows with the nodes and corners looked at
  bool anyIn(Vec2 a, Vec2 b, Vec2 c, std::size_t& tests) const {
    if (order_.empty()) return false;
    std::array<std::size_t, 64> waiting;  // at most 32 levels, and one node waits on each
    std::size_t count = 0;
    waiting[count++] = 1;
    while (count > 0) {
      const std::size_t index = waiting[--count];
      const Node& node = nodes_[index];
      ++tests;
      if (node.left == 0 || isOutside(node.box, a, b, c)) continue;
      if (2 * index < nodes_.size()) {
        waiting[count++] = 2 * index + 1;
        waiting[count++] = 2 * index;
        continue;
      }
      tests += node.end - node.begin;
      for (std::size_t i = node.begin; i < node.end; ++i)
        if (leafOf_[order_[i]] != 0 && blocks(flat_[order_[i]], a, b, c)) return true;
    }
    return false;
  }

 private:
  static constexpr std::size_t kLeafSize = 8;

  struct Box {
    Vec2 min, max;

    Vec2 size() const { return max - min; }
    double area() const { return size().x * size().y; }
  };

  struct Node {
    std::size_t begin, end, left;
    Box box;
  };

  void build(std::size_t index, std::size_t begin, std::size_t end) {
    nodes_[index] = {begin, end, end - begin, boxOf(begin, end)};
    if (2 * index >= nodes_.size()) {
      for (std::size_t i = begin; i < end; ++i) leafOf_[order_[i]] = static_cast<std::uint32_t>(index);
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    const Vec2 size = nodes_[index].box.size();
    const int axis = size.x >= size.y ? 0 : 1;
    std::nth_element(at(begin), at(middle), at(end));
    if (boxOf(begin, middle).area() + boxOf(middle, end).area() > size.x * size.y)
      std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t i, std::uint32_t j) {
        return std::pair(flat_[i][axis], i) < std::pair(flat_[j][axis], j);
      });
    build(2 * index, begin, middle);
    build(2 * index + 1, middle, end);
  }

  Box boxOf(std::size_t begin, std::size_t end) const {
    Box box{flat_[order_[begin]], flat_[order_[begin]]};
    for (std::size_t i = begin; i < end; ++i) {
      box.min = glm::min(box.min, flat_[order_[i]]);
      box.max = glm::max(box.max, flat_[order_[i]]);
    }
    return box;
  }

  /// Returns true if the whole box lies beyond one edge. Rounding is monotonic, so testing the box's farthest corner
  /// covers every point in it.
  static bool isOutside(const Box& box, Vec2 a, Vec2 b, Vec2 c) {
    const auto beyond = [&box](Vec2 from, Vec2 to) {
      const Vec2 along = to - from;
      const Vec2 farthest(along.y > 0 ? box.min.x : box.max.x, along.x > 0 ? box.max.y : box.min.y);
      return cross2(along, farthest - from) < 0;
    };
    return beyond(a, b) || beyond(b, c) || beyond(c, a);
  }

  std::span<const Vec2> flat_;
  std::vector<std::uint32_t> order_;   // reflex corners; the corners of a node are adjacent
  std::vector<std::uint32_t> leafOf_;  // leaf of each corner of the outline; 0: not in the tree
  std::vector<Node> nodes_;            // node i has the children 2i and 2i + 1; the root is 1
};

/// Ear clipping on a ring of corners. A cut can turn only its two neighbours into ears, so only these are looked at
/// again: a simple outline takes at most three looks per corner.
class EarClipper {
 public:
  explicit EarClipper(std::span<const Vec2> flat)
      : flat_(flat),
        left_(flat.size()),
        maxTests_(kMinTests + kTestsPerCorner * flat.size()),
        isLarge_(flat.size() > kLargeOutline) {
    const auto n = static_cast<std::uint32_t>(flat.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      next_.push_back((i + 1) % n);
      previous_.push_back((i + n - 1) % n);
    }
    std::vector<std::uint32_t> reflex;
    for (std::uint32_t i = 0; i < n; ++i)
      if (!isConvex(i)) reflex.push_back(i);
    reflex_ = ReflexTree(flat, std::move(reflex));
    turn_.assign(n, 0);
  }

  PolygonTriangles clipAll() {
    PolygonTriangles result;
    std::uint32_t corner = 0;  // any remaining corner
    while (left_ > 3 && tests_ < maxTests_) {
      const std::size_t before = left_;
      lookAtAll(corner);
      clipEars(corner, result);
      if (left_ < before || left_ <= 3 || tests_ >= maxTests_) continue;
      if (std::exchange(straightSine_, 0.0) > 0) continue;  // very acute corners also look straight
      if (std::exchange(result.simple, false))
        maxTests_ = std::min(maxTests_, tests_ + kMinCrossedTests + kTestsPerCrossedCorner * left_);
      corner = clip(corner, result);
    }
    std::vector<std::uint32_t> rest;
    for (std::size_t i = 0; i < left_; ++i, corner = next_[corner]) rest.push_back(corner);
    const auto hasArea = [&](std::size_t k) {
      return turnsLeft(at(rest[k]), at(rest[(k + 1) % 3]), at(rest[(k + 2) % 3]), straightSine_);
    };
    if (rest.size() > 3 || !(hasArea(0) || hasArea(1) || hasArea(2))) result.simple = false;
    appendFan(rest, 0, result.triangles);
    result.tests = tests_;
    return result;
  }

 private:
  /// A corner that may be an ear. In a large outline the shortest cuts come first, which keeps the ears small and the
  /// tree's answers near. In other outlines the first entry comes first.
  struct Look {
    double cut;
    std::uint64_t entry;
    std::uint32_t corner, turn;

    bool operator>(const Look& other) const {
      return std::tie(cut, entry, corner, turn) > std::tie(other.cut, other.entry, other.corner, other.turn);
    }
  };

  Vec2 at(std::uint32_t i) const { return flat_[i]; }
  bool isConvex(std::uint32_t i) const { return turnsLeft(at(previous_[i]), at(i), at(next_[i]), straightSine_); }

  bool isEar(std::uint32_t i) {
    ++tests_;
    return isConvex(i) && !reflex_.anyIn(at(previous_[i]), at(i), at(next_[i]), tests_);
  }

  void lookAt(std::uint32_t i) {
    const double cut = isLarge_ ? glm::distance(at(previous_[i]), at(next_[i])) : 0;
    queue_.push({cut, entries_++, i, ++turn_[i]});
  }

  void lookAtAll(std::uint32_t from) {
    queue_ = {};
    for (std::size_t i = 0; i < left_; ++i, from = next_[from]) lookAt(from);
  }

  /// Clips the ears in the queue.
  /// @param corner  becomes a remaining corner
  void clipEars(std::uint32_t& corner, PolygonTriangles& result) {
    for (; !queue_.empty() && left_ > 3 && tests_ < maxTests_;) {
      const auto [cut, entry, i, turn] = queue_.top();
      queue_.pop();
      if (turn != turn_[i] || !isEar(i)) continue;  // already clipped, or queued again farther back
      corner = clip(i, result);
    }
  }

  /// Cuts the corner off. Its neighbours go to the end of the queue, so that the cuts are spread over the outline.
  /// @returns the corner after the next one
  std::uint32_t clip(std::uint32_t i, PolygonTriangles& result) {
    const std::uint32_t before = previous_[i];
    const std::uint32_t after = next_[i];
    result.triangles.push_back({before, i, after});
    next_[before] = after;
    previous_[after] = before;
    ++turn_[i];
    reflex_.remove(i);
    --left_;
    for (const std::uint32_t neighbour : {before, after}) {
      if (isConvex(neighbour)) reflex_.remove(neighbour);
      lookAt(neighbour);
    }
    return next_[after];
  }

  std::span<const Vec2> flat_;
  std::size_t left_;
  std::size_t maxTests_;
  bool isLarge_;
  double straightSine_ = kStraightSine;
  std::vector<std::uint32_t> next_, previous_;
  ReflexTree reflex_{{}, {}};  // a convex corner never becomes reflex
  std::priority_queue<Look, std::vector<Look>, std::greater<>> queue_;
  std::vector<std::uint32_t> turn_;  // the turn of each corner's last entry; older entries are void
  std::uint64_t entries_ = 0;
  std::size_t tests_ = 0;
};

}  // namespace

PolygonTriangles triangulatePolygon(std::span<const Vec3> corners) {
  std::vector<std::uint32_t> outline(corners.size());
  for (std::uint32_t i = 0; i < outline.size(); ++i) outline[i] = i;
  PolygonTriangles result;
  const Vec3 sum = newellNormal(corners);
  const double length = glm::length(sum);
  if (corners.size() == 3 || !(length > 0) || !std::isfinite(length)) {
    result.simple = length > 0;
    appendFan(outline, 0, result.triangles);
    return result;
  }
  const std::vector<Vec2> flat = flattened(corners, sum / length);
  const bool first = fanIsValid(flat, 0);
  const bool second = corners.size() == 4 && fanIsValid(flat, 1);
  if (first || second) {
    const bool secondIsShorter =
        second && glm::distance(corners[1], corners[3]) < glm::distance(corners[0], corners[2]);
    appendFan(outline, !first || secondIsShorter ? 1 : 0, result.triangles);
    return result;
  }
  return EarClipper(flat).clipAll();
}

}  // namespace qrelief
