// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/bvh.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace qrelief {
namespace {

constexpr std::uint32_t kLeafSize = 4;
constexpr int kBins = 12;

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

}  // namespace

Bvh::Bvh(std::span<const Box> boxes) {
  const auto count = static_cast<std::uint32_t>(boxes.size());
  std::vector<Vec3f> twiceCentres;
  twiceCentres.reserve(count);
  for (const Box& box : boxes) twiceCentres.push_back(box.min + box.max);
  order_.resize(count);
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.reserve(count);
  if (count > 0) build(0, count, 0, twiceCentres, boxes);
}

std::uint32_t Bvh::build(std::uint32_t begin, std::uint32_t end, int level, const std::vector<Vec3f>& twiceCentres,
                         std::span<const Box> boxes) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  Bounds bounds, centres;
  for (std::uint32_t i = begin; i < end; ++i) {
    bounds.add(boxes[order_[i]].min, boxes[order_[i]].max);
    centres.add(twiceCentres[order_[i]], twiceCentres[order_[i]]);
  }
  nodes_.push_back({{bounds.min, bounds.max}, begin, end - begin});
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
    inBin[bin].add(boxes[order_[i]].min, boxes[order_[i]].max);
    ++countOf[bin];
  }
  std::array<double, kBins> costAbove{};  // of all boxes from this bin on
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

}  // namespace qrelief
