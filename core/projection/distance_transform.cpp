// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/distance_transform.h"

#include <algorithm>
#include <cassert>

namespace qrelief {
namespace {

/// Computes the distance to the nearest blocked texel of the same column; larger than any distance of the map if there
/// is none.
std::vector<std::int32_t> columnDistances(std::span<const std::uint8_t> blocked, int texels) {
  const auto size = static_cast<std::size_t>(texels);
  std::vector<std::int32_t> distance(blocked.size());
  const std::int32_t far = 2 * texels;
  for (std::size_t i = 0; i < blocked.size(); ++i) {
    const std::int32_t above = i < size ? far : distance[i - size];
    distance[i] = blocked[i] != 0 ? 0 : std::min(far, above + 1);
  }
  for (std::size_t i = blocked.size() - size; i-- > 0;) distance[i] = std::min(distance[i], distance[i + size] + 1);
  return distance;
}

/// The parabolas x ↦ (x - q)² + f(q) of one row, restricted to where each is lowest.
class LowerEnvelope {
 public:
  explicit LowerEnvelope(int texels)
      : vertex_(static_cast<std::size_t>(texels)), begin_(static_cast<std::size_t>(texels)) {}

  /// Replaces the squared distances within a column by those within all columns.
  void replaceRow(std::int32_t* row, int texels) {
    for (int begin = 0; begin < texels; ++begin) {
      if (row[begin] == 0) continue;
      int end = begin + 1;
      while (end < texels && row[end] != 0) ++end;
      // The blocked texels at both ends are nearer than anything beyond them.
      const int first = std::max(begin - 1, 0);
      replaceRun(row + first, std::min(end + 1, texels) - first);
      begin = end;
    }
  }

 private:
  void replaceRun(std::int32_t* row, int texels) {
    height_.assign(row, row + texels);
    std::size_t last = 0;
    vertex_[0] = 0;
    begin_[0] = 0;
    for (int q = 1; q < texels; ++q) {
      // The new parabola takes over from the last one where it becomes lower. If that is before the last one began, the
      // last one is nowhere lowest.
      int from = firstLower(vertex_[last], q);
      while (last > 0 && from <= begin_[last]) from = firstLower(vertex_[--last], q);
      if (last == 0 && from <= 0) {
        vertex_[0] = q;
      } else if (from < texels) {
        vertex_[++last] = q;
        begin_[last] = from;
      }
    }
    std::size_t current = 0;
    for (int x = 0; x < texels; ++x) {
      while (current < last && begin_[current + 1] <= x) ++current;
      const int across = x - vertex_[current];
      row[x] = across * across + height_[vertex_[current]];
    }
  }

  /// Returns the least x ≥ 0 at which the parabola of q is not higher than the parabola of p < q.
  int firstLower(int p, int q) const {
    const std::int32_t numerator = q * q - p * p + height_[q] - height_[p];
    const std::int32_t denominator = 2 * (q - p);
    return numerator <= 0 ? 0 : (numerator + denominator - 1) / denominator;
  }

  std::vector<std::int32_t> height_;
  std::vector<int> vertex_, begin_;
};

}  // namespace

std::vector<std::int32_t> squaredDistances(std::span<const std::uint8_t> blocked, int texels) {
  assert(texels > 0 && texels < 8192 &&
         blocked.size() == static_cast<std::size_t>(texels) * static_cast<std::size_t>(texels));
  std::vector<std::int32_t> squared = columnDistances(blocked, texels);
  for (std::int32_t& d : squared) d *= d;
  LowerEnvelope envelope(texels);
  for (int row = 0; row < texels; ++row) envelope.replaceRow(squared.data() + row * texels, texels);
  return squared;
}

}  // namespace qrelief
