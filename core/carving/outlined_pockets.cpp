// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/outlined_pockets.h"

#include <algorithm>
#include <cmath>

#include "math/tolerance.h"

namespace qrelief {

bool overlaps(const Triangle2& t, Vec2 low, Vec2 high) {
  for (int axis = 0; axis < 2; ++axis) {
    if (std::max({t[0][axis], t[1][axis], t[2][axis]}) < low[axis]) return false;
    if (std::min({t[0][axis], t[1][axis], t[2][axis]}) > high[axis]) return false;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 edge = t[(k + 1) % 3] - t[k];
    // The corner farthest to the edge's left.
    const Vec2 innermost(edge.y > 0 ? low.x : high.x, edge.x > 0 ? high.y : low.y);
    if (cross2(edge, innermost - t[k]) < 0) return false;
  }
  return true;
}

bool touches(const Triangle2& triangle, const OutlinedPockets& pockets, double marginMm) {
  return std::any_of(pockets.covered.begin(), pockets.covered.end(),
                     [&](const Rectangle& box) { return overlaps(triangle, box.low - marginMm, box.high + marginMm); });
}

void addOutlines(OutlineGraph& graph, const OutlinedPockets& pockets, double longestMm) {
  constexpr double kLeeway = 1.0 / 8;
  const int level = static_cast<int>(std::lround(pockets.depthMm / kDepthQuantumMm));
  for (const Ring& ring : pockets.rings) {
    Ring points;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 from = ring[i], to = ring[(i + 1) % ring.size()];
      const int parts = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / longestMm)));
      for (int k = 0; k < parts; ++k) points.push_back(from + (to - from) * (static_cast<double>(k) / parts));
    }
    const auto first = static_cast<std::uint32_t>(graph.nodes.size());
    const auto count = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      const double before = glm::distance(points[i], points[(i + count - 1) % count]);
      const double after = glm::distance(points[i], points[(i + 1) % count]);
      graph.nodes.push_back(points[i]);
      graph.leewayMm.push_back(kLeeway * std::min(before, after));
      graph.outlines.push_back({first + i, first + (i + 1) % count, level, 0});
    }
  }
}

}  // namespace qrelief
