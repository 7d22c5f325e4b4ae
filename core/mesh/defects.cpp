// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/defects.h"

#include <numeric>

namespace qrelief {
namespace {

/// Disjoint sets of vertices, to count the loops of open edges.
class VertexSets {
 public:
  explicit VertexSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t find(std::uint32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }
  /// Joins two vertices' sets; returns true if they were separate.
  bool join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

Triangle edgeEnds(const Mesh& mesh, std::uint32_t halfEdge) {
  const Triangle& t = mesh.triangles[halfEdge / 3];
  return {t[halfEdge % 3], t[(halfEdge + 1) % 3], 0};
}

Vec3 middleOf(const Mesh& mesh, std::uint32_t halfEdge) {
  const Triangle ends = edgeEnds(mesh, halfEdge);
  return (Vec3(mesh.positions[ends[0]]) + Vec3(mesh.positions[ends[1]])) * 0.5;
}

/// Counts the connected groups of open edges: their vertices less the joins between them.
std::size_t countHoles(const Mesh& mesh, const EdgeTable& edges) {
  VertexSets sets(mesh.positions.size());
  std::vector<char> touched(mesh.positions.size(), 0);
  std::size_t groups = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.at(e).size() != 1) continue;
    const Triangle ends = edgeEnds(mesh, edges.at(e)[0]);
    for (std::size_t k = 0; k < 2; ++k) {
      groups += touched[ends[k]] == 0;
      touched[ends[k]] = 1;
    }
    groups -= sets.join(ends[0], ends[1]);
  }
  return groups;
}

/// Counts the triangles on a walk around one corner's vertex; in a closed mesh the walk returns to the start.
std::size_t fanSize(const Mesh& mesh, const Adjacency& adjacency, std::uint32_t triangle, std::uint32_t vertex) {
  std::size_t size = 0;
  std::uint32_t t = triangle;
  std::uint32_t from = kNoTriangle;
  do {
    const Triangle& corners = mesh.triangles[t];
    const std::size_t k = corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
    // Of the two edges at the vertex, k leads away from it and k + 2 towards it. Leave by the edge not entered by.
    const std::uint32_t away = adjacency[t][k];
    const std::uint32_t next = away != from ? away : adjacency[t][(k + 2) % 3];
    from = t;
    t = next;
    ++size;
  } while (t != triangle && size <= adjacency.size());
  return size;
}

void findNonManifoldVertices(const Mesh& mesh, const Adjacency& adjacency, Defects& defects) {
  std::vector<std::uint32_t> valence(mesh.positions.size(), 0);
  std::vector<std::uint32_t> anyTriangle(mesh.positions.size(), kNoTriangle);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t]) {
      ++valence[v];
      if (anyTriangle[v] == kNoTriangle) anyTriangle[v] = t;
    }
  for (std::uint32_t v = 0; v < valence.size(); ++v) {
    if (valence[v] == 0 || fanSize(mesh, adjacency, anyTriangle[v], v) == valence[v]) continue;
    if (defects.nonManifoldVertices++ == 0) defects.nonManifoldVertexAt = Vec3(mesh.positions[v]);
  }
}

}  // namespace

Defects findDefects(const Mesh& mesh, const EdgeTable& edges, const Adjacency& adjacency) {
  Defects defects;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::span<const std::uint32_t> users = edges.at(e);
    if (users.size() == 2) continue;
    if (users.size() == 1 && defects.openEdges++ == 0) {
      defects.openAt = middleOf(mesh, users[0]);
      defects.openTriangle = users[0] / 3;
    }
    if (users.size() > 2 && defects.nonManifoldEdges++ == 0) {
      defects.nonManifoldEdgeAt = middleOf(mesh, users[0]);
      for (const std::uint32_t h : users) defects.nonManifoldTriangles.push_back(h / 3);
    }
  }
  if (defects.openEdges > 0) defects.holes = countHoles(mesh, edges);
  if (defects.openEdges == 0 && defects.nonManifoldEdges == 0) findNonManifoldVertices(mesh, adjacency, defects);
  return defects;
}

}  // namespace qrelief
