// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/topology.h"

#include <algorithm>
#include <cassert>

namespace qrelief {

Adjacency buildAdjacency(std::span<const Triangle> triangles) {
  struct HalfEdge {
    std::uint64_t key;  // smaller vertex, larger vertex
    std::uint32_t slot;  // 3·triangle + edge
  };
  std::vector<HalfEdge> edges(3 * triangles.size());
  for (std::uint32_t slot = 0; slot < edges.size(); ++slot) {
    const Triangle& t = triangles[slot / 3];
    const std::uint64_t a = t[slot % 3];
    const std::uint64_t b = t[(slot + 1) % 3];
    edges[slot] = {std::min(a, b) << 32 | std::max(a, b), slot};
  }
  std::sort(edges.begin(), edges.end(),
            [](const HalfEdge& x, const HalfEdge& y) { return x.key != y.key ? x.key < y.key : x.slot < y.slot; });

  Adjacency adjacency(triangles.size(), {kNoTriangle, kNoTriangle, kNoTriangle});
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin + 1;
    while (end < edges.size() && edges[end].key == edges[begin].key) ++end;
    if (end - begin == 2) {
      const std::uint32_t a = edges[begin].slot;
      const std::uint32_t b = edges[begin + 1].slot;
      adjacency[a / 3][a % 3] = b / 3;
      adjacency[b / 3][b % 3] = a / 3;
    }
    begin = end;
  }
  return adjacency;
}

int sharedEdge(const Adjacency& adjacency, std::uint32_t across, std::uint32_t triangle) {
  for (int k = 0; k < 3; ++k)
    if (adjacency[across][static_cast<std::size_t>(k)] == triangle) return k;
  assert(false && "the triangles share no edge");
  return -1;
}

}  // namespace qrelief
