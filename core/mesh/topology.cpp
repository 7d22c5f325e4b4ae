// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/topology.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace qrelief {

namespace {

std::uint32_t countVertices(std::span<const Triangle> triangles) {
  std::uint32_t count = 0;
  for (const Triangle& t : triangles) count = std::max({count, t[0] + 1, t[1] + 1, t[2] + 1});
  return count;
}

}  // namespace

EdgeTable buildEdgeTable(std::span<const Triangle> triangles) {
  // begins[v] … begins[v + 1]: the half-edges whose smaller vertex is v.
  std::vector<std::uint32_t> begins(std::size_t{countVertices(triangles)} + 2, 0);
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) ++begins[std::size_t{std::min(t[k], t[(k + 1) % 3])} + 2];
  for (std::size_t v = 2; v < begins.size(); ++v) begins[v] += begins[v - 1];
  std::vector<std::uint64_t> keys(3 * triangles.size());  // larger vertex, half-edge
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t][k];
      const std::uint32_t b = triangles[t][(k + 1) % 3];
      keys[begins[std::size_t{std::min(a, b)} + 1]++] = std::uint64_t{std::max(a, b)} << 32 | (3 * t + k);
    }

  EdgeTable table;
  table.halfEdges.reserve(keys.size());
  table.begins.reserve(keys.size() / 2 + 2);
  for (std::size_t v = 0; v + 1 < begins.size(); ++v) {
    const auto first = keys.begin() + begins[v];
    const auto last = keys.begin() + begins[v + 1];
    std::sort(first, last);
    for (auto key = first; key != last; ++key) {
      if (key == first || *key >> 32 != *(key - 1) >> 32)
        table.begins.push_back(static_cast<std::uint32_t>(table.halfEdges.size()));
      table.halfEdges.push_back(static_cast<std::uint32_t>(*key));
    }
  }
  table.begins.push_back(static_cast<std::uint32_t>(table.halfEdges.size()));
  return table;
}

Adjacency buildAdjacency(std::span<const Triangle> triangles, const EdgeTable& edges) {
  Adjacency adjacency(triangles.size(), {kNoTriangle, kNoTriangle, kNoTriangle});
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::span<const std::uint32_t> pair = edges.at(e);
    if (pair.size() != 2) continue;
    adjacency[pair[0] / 3][pair[0] % 3] = pair[1] / 3;
    adjacency[pair[1] / 3][pair[1] % 3] = pair[0] / 3;
  }
  return adjacency;
}

Adjacency buildAdjacency(std::span<const Triangle> triangles) {
  return buildAdjacency(triangles, buildEdgeTable(triangles));
}

int sharedEdge(const Adjacency& adjacency, std::uint32_t across, std::uint32_t triangle) {
  for (int k = 0; k < 3; ++k)
    if (adjacency[across][k] == triangle) return k;
  assert(false && "the triangles share no edge");
  return -1;
}

std::vector<std::uint32_t> piecesOf(const Mesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto find = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t other : {t[1], t[2]}) {
      const std::uint32_t a = find(t[0]), b = find(other);
      parent[std::max(a, b)] = std::min(a, b);
    }
  for (std::uint32_t v = 0; v < parent.size(); ++v) parent[v] = find(v);
  return parent;
}

CornerFans::CornerFans(const Mesh& mesh) : mesh_(mesh), parent_(3 * mesh.triangles.size()) {
  std::iota(parent_.begin(), parent_.end(), 0u);
}

std::uint32_t CornerFans::find(std::uint32_t corner) {
  while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
  return corner;
}

std::uint32_t CornerFans::cornerAt(std::uint32_t halfEdge, std::uint32_t vertex) const {
  const Triangle& t = mesh_.triangles[halfEdge / 3];
  return halfEdge - halfEdge % 3 + (t[0] == vertex ? 0u : t[1] == vertex ? 1u : 2u);
}

void CornerFans::joinAlong(std::uint32_t halfEdge, std::uint32_t other) {
  const Triangle& t = mesh_.triangles[halfEdge / 3];
  for (const std::uint32_t vertex : {t[halfEdge % 3], t[(halfEdge + 1) % 3]}) {
    const std::uint32_t a = find(cornerAt(halfEdge, vertex)), b = find(cornerAt(other, vertex));
    parent_[std::max(a, b)] = std::min(a, b);
  }
}

}  // namespace qrelief
