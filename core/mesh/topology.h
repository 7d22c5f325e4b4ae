// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace qrelief {

inline constexpr std::uint32_t kNoTriangle = 0xffffffffu;

/// The half-edges of a triangle mesh, grouped by the undirected edge they run along. Half-edge 3·triangle + k runs from
/// corner k to corner k+1 mod 3.
struct EdgeTable {
  /// Edge after edge, sorted by smaller, then larger vertex; ascending within an edge.
  std::vector<std::uint32_t> halfEdges;
  std::vector<std::uint32_t> begins;  ///< index of each edge's first half-edge; the last entry is the end

  std::size_t size() const { return begins.size() - 1; }
  std::span<const std::uint32_t> at(std::size_t edge) const {
    return std::span(halfEdges).subspan(begins[edge], begins[edge + 1] - begins[edge]);
  }
};

/// Builds the table: sorts half-edges into bins by their smaller vertex, then within each bin. Without hashing, so the
/// result depends only on the input. Cost: O(T).
/// @param triangles  at most 2^32/3, each of three different vertices
EdgeTable buildEdgeTable(std::span<const Triangle> triangles);

/// The half-edge structure of a triangle mesh: for each triangle `t` and edge `k` (from corner k to
/// corner k+1 mod 3) the triangle on the other side, or kNoTriangle where the edge is open or shared by
/// more than two triangles.
using Adjacency = std::vector<std::array<std::uint32_t, 3>>;

Adjacency buildAdjacency(std::span<const Triangle> triangles);
Adjacency buildAdjacency(std::span<const Triangle> triangles, const EdgeTable& edges);

/// Returns the edge of `across` that it shares with `triangle`. Precondition: they share an edge.
int sharedEdge(const Adjacency& adjacency, std::uint32_t across, std::uint32_t triangle);

/// Returns the piece of each vertex: the lowest vertex that can be reached over triangles. Cost: O(T).
std::vector<std::uint32_t> piecesOf(const Mesh& mesh);

/// The fans of a mesh: triangles round a vertex that are joined along edges. Corner k of triangle t has number 3·t + k;
/// corners of one fan have one representative.
class CornerFans {
 public:
  /// Starts with every corner alone.
  explicit CornerFans(const Mesh& mesh);

  /// Joins the triangles of two half-edges of the same edge, at both of its ends.
  void joinAlong(std::uint32_t halfEdge, std::uint32_t other);

  /// Returns the lowest corner of a corner's fan.
  std::uint32_t find(std::uint32_t corner);

 private:
  std::uint32_t cornerAt(std::uint32_t halfEdge, std::uint32_t vertex) const;

  const Mesh& mesh_;
  std::vector<std::uint32_t> parent_;
};

}  // namespace qrelief
