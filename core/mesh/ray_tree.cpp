// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/ray_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "mesh/sheared_ray.h"

namespace qrelief {
namespace {

constexpr std::uint32_t kLeafSize = 4;
constexpr int kBins = 12;
constexpr int kMaxLevel = 100;  // bounds the stack of a query

struct Bounds {
  Vec3f min{std::numeric_limits<float>::infinity()};
  Vec3f max{-std::numeric_limits<float>::infinity()};

  void add(Vec3f low, Vec3f high) {
    min = glm::min(min, low);
    max = glm::max(max, high);
  }
  double halfArea() const {
    const Vec3 size = Vec3(max) - Vec3(min);
    return size.x * size.y + size.y * size.z + size.z * size.x;
  }
};

/// Part of the ray that lies in the box, widened by what rounding may cost [Ize 2013].
bool meetsBox(Vec3f min, Vec3f max, Vec3 origin, Vec3 inverse, double nearest, double farthest) {
  for (int axis = 0; axis < 3; ++axis) {
    double enter = (static_cast<double>(min[axis]) - origin[axis]) * inverse[axis];
    double leave = (static_cast<double>(max[axis]) - origin[axis]) * inverse[axis];
    if (enter > leave) std::swap(enter, leave);
    // NaN (the origin lies on a side that the ray runs along) leaves the bounds as they are.
    if (enter > nearest) nearest = enter;
    if (leave < farthest) farthest = leave;
  }
  return nearest <= farthest * (1 + 4 * std::numeric_limits<double>::epsilon());
}

}  // namespace

RayTree::RayTree(const Mesh& mesh) : mesh_(&mesh) {
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  std::vector<Node> boxes(count);
  std::vector<Vec3f> twiceCentres(count);
  for (std::uint32_t t = 0; t < count; ++t) {
    Bounds bounds;
    for (const std::uint32_t v : mesh.triangles[t]) bounds.add(mesh.positions[v], mesh.positions[v]);
    boxes[t] = {bounds.min, bounds.max, 0, 0};
    twiceCentres[t] = bounds.min + bounds.max;
  }
  order_.resize(count);
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.reserve(count);
  if (count > 0) build(0, count, 0, twiceCentres, boxes);
}

std::uint32_t RayTree::build(std::uint32_t begin, std::uint32_t end, int level, const std::vector<Vec3f>& twiceCentres,
                             const std::vector<Node>& boxes) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  Bounds bounds, centres;
  for (std::uint32_t i = begin; i < end; ++i) {
    bounds.add(boxes[order_[i]].min, boxes[order_[i]].max);
    centres.add(twiceCentres[order_[i]], twiceCentres[order_[i]]);
  }
  nodes_.push_back({bounds.min, bounds.max, begin, end - begin});
  const Vec3f size = centres.max - centres.min;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  if (end - begin <= kLeafSize || level == kMaxLevel || !(size[axis] > 0)) return index;

  const auto binOf = [&](std::uint32_t t) {
    const float place = (twiceCentres[t][axis] - centres.min[axis]) / size[axis];
    return std::min(kBins - 1, static_cast<int>(place * kBins));
  };
  std::array<Bounds, kBins> inBin;
  std::array<std::uint32_t, kBins> countOf{};
  for (std::uint32_t i = begin; i < end; ++i) {
    const int bin = binOf(order_[i]);
    inBin[static_cast<std::size_t>(bin)].add(boxes[order_[i]].min, boxes[order_[i]].max);
    ++countOf[static_cast<std::size_t>(bin)];
  }
  std::array<double, kBins> costAbove{};  // of everything from this bin on
  Bounds above;
  std::uint32_t countAbove = 0;
  for (std::size_t bin = kBins - 1; bin > 0; --bin) {
    above.add(inBin[bin].min, inBin[bin].max);
    countAbove += countOf[bin];
    costAbove[bin] = countAbove ? countAbove * above.halfArea() : 0;
  }
  Bounds below;
  std::uint32_t countBelow = 0;
  double least = std::numeric_limits<double>::infinity();
  int split = 1;
  for (std::size_t bin = 0; bin + 1 < kBins; ++bin) {
    below.add(inBin[bin].min, inBin[bin].max);
    countBelow += countOf[bin];
    if (countBelow == 0 || countBelow == end - begin) continue;
    const double cost = countBelow * below.halfArea() + costAbove[bin + 1];
    if (cost < least) {
      least = cost;
      split = static_cast<int>(bin) + 1;
    }
  }
  const auto middle =
      std::partition(order_.begin() + begin, order_.begin() + end, [&](std::uint32_t t) { return binOf(t) < split; });
  const auto at = static_cast<std::uint32_t>(middle - order_.begin());
  build(begin, at, level + 1, twiceCentres, boxes);
  const std::uint32_t second = build(at, end, level + 1, twiceCentres, boxes);
  nodes_[index].begin = second;
  nodes_[index].count = 0;
  return index;
}

std::optional<SurfacePoint> RayTree::firstHit(Vec3 origin, Vec3 direction, double from) const {
  if (nodes_.empty()) return std::nullopt;
  const ShearedRay ray(origin, direction);
  const Vec3 inverse = 1.0 / direction;
  double nearest = std::numeric_limits<double>::infinity();
  std::uint32_t found = 0;
  std::array<std::uint32_t, kMaxLevel + 2> waiting{};
  std::size_t depth = 0;
  waiting[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t index = waiting[--depth];
    const Node& node = nodes_[index];
    if (!meetsBox(node.min, node.max, origin, inverse, from, nearest)) continue;
    if (node.count == 0) {
      // Nearer child first: along the axis on which their middles are farthest apart.
      const Node& first = nodes_[index + 1];
      const Node& second = nodes_[node.begin];
      const Vec3 apart = Vec3(second.min + second.max) - Vec3(first.min + first.max);
      const bool firstIsNearer = glm::dot(apart, direction) > 0;
      waiting[depth++] = firstIsNearer ? node.begin : index + 1;
      waiting[depth++] = firstIsNearer ? index + 1 : node.begin;
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.begin + node.count; ++i) {
      const std::uint32_t t = order_[i];
      const double parameter =
          hitParameter(ray.apply(mesh_->corner(t, 0)), ray.apply(mesh_->corner(t, 1)), ray.apply(mesh_->corner(t, 2)));
      if (parameter <= from || parameter < 0) continue;
      if (parameter < nearest || (parameter == nearest && t < found)) {
        nearest = parameter;
        found = t;
      }
    }
  }
  if (!(nearest < std::numeric_limits<double>::infinity())) return std::nullopt;
  return SurfacePoint{origin + direction * nearest, found, nearest * glm::length(direction)};
}

}  // namespace qrelief
