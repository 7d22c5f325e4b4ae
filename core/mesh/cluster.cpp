// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cluster.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace qrelief {
namespace {

struct KeyedVertex {
  std::uint64_t cell;
  std::uint32_t vertex;
  bool operator<(const KeyedVertex& other) const {
    return cell != other.cell ? cell < other.cell : vertex < other.vertex;
  }
};

/// Vertices of one cell whose normals point to the same side.
struct Cluster {
  Vec3 positions{0}, normals{0};  // sums
  std::uint32_t count = 0;
};

std::vector<KeyedVertex> verticesByCell(const Mesh& mesh, double cellMm) {
  constexpr double kMaxCells = 1 << 20;  // along an axis, so that three indices fit into a key
  const Box3 box = boundingBox(mesh);
  const Vec3 size = box.size();
  const double cell = std::max(cellMm, std::max({size.x, size.y, size.z}) / kMaxCells);
  std::vector<KeyedVertex> keyed(mesh.positions.size());
  for (std::uint32_t v = 0; v < keyed.size(); ++v) {
    const Vec3 at = (Vec3(mesh.positions[v]) - box.min) / cell;
    std::uint64_t key = 0;
    for (int k = 0; k < 3; ++k) key = key << 21 | static_cast<std::uint64_t>(at[k]);
    keyed[v] = {key, v};
  }
  std::sort(keyed.begin(), keyed.end());
  return keyed;
}

/// A facet with its corners in ascending order, and the parity of the swaps.
struct SortedFacet {
  Triangle corners;
  bool turned = false;
  std::uint32_t triangle = 0;
};

SortedFacet sorted(const Triangle& triangle, std::uint32_t index) {
  SortedFacet facet{triangle, false, index};
  Triangle& c = facet.corners;
  for (const auto& [a, b] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 2}, {0, 1}}) {
    if (c[a] <= c[b]) continue;
    std::swap(c[a], c[b]);
    facet.turned = !facet.turned;
  }
  return facet;
}

/// Drops superfluous facets. Among facets with the same three vertices, pairs that face opposite ways cancel out; at
/// most one facet stays.
std::vector<Triangle> withoutFlaps(const std::vector<Triangle>& triangles) {
  std::vector<SortedFacet> facets;
  facets.reserve(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) facets.push_back(sorted(triangles[t], t));
  std::sort(facets.begin(), facets.end(), [](const SortedFacet& a, const SortedFacet& b) {
    return a.corners != b.corners ? a.corners < b.corners : a.triangle < b.triangle;
  });
  std::vector<std::uint8_t> stays(triangles.size(), 0);
  for (std::size_t begin = 0; begin < facets.size();) {
    std::size_t end = begin;
    int balance = 0;
    for (; end < facets.size() && facets[end].corners == facets[begin].corners; ++end)
      balance += facets[end].turned ? -1 : 1;
    for (std::size_t i = begin; i < end && balance != 0; ++i) {
      if (facets[i].turned != (balance < 0)) continue;
      stays[facets[i].triangle] = 1;
      break;
    }
    begin = end;
  }
  std::vector<Triangle> remaining;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (stays[t] != 0) remaining.push_back(triangles[t]);
  return remaining;
}

}  // namespace

ClusteredMesh clusterVertices(const Mesh& mesh, std::span<const Vec3f> normals, double cellMm) {
  assert(normals.size() == mesh.positions.size() && cellMm > 0);
  ClusteredMesh result;
  result.clusterOf.resize(mesh.positions.size());
  const std::vector<KeyedVertex> keyed = verticesByCell(mesh, cellMm);
  std::vector<Cluster> clusters;  // of one cell
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    const std::uint32_t v = keyed[i].vertex;
    const Vec3 normal(normals[v]);
    std::size_t c = 0;
    while (c < clusters.size() && glm::dot(clusters[c].normals, normal) < 0) ++c;
    if (c == clusters.size()) clusters.push_back({});
    clusters[c].positions += Vec3(mesh.positions[v]);
    clusters[c].normals += normal;
    ++clusters[c].count;
    result.clusterOf[v] = static_cast<std::uint32_t>(result.mesh.positions.size() + c);
    if (i + 1 < keyed.size() && keyed[i + 1].cell == keyed[i].cell) continue;
    for (const Cluster& cluster : clusters)
      result.mesh.positions.emplace_back(cluster.positions / static_cast<double>(cluster.count));
    clusters.clear();
  }

  std::vector<Triangle> triangles;
  for (const Triangle& t : mesh.triangles) {
    const Triangle moved{result.clusterOf[t[0]], result.clusterOf[t[1]], result.clusterOf[t[2]]};
    if (moved[0] != moved[1] && moved[1] != moved[2] && moved[2] != moved[0]) triangles.push_back(moved);
  }
  result.mesh.triangles = withoutFlaps(triangles);
  return result;
}

}  // namespace qrelief
