// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/box_tree.h"
#include "mesh/topology.h"

namespace qrelief {

/// The open edges of a mesh, with a search for nearby ones. An open edge has one triangle.
class OpenBorder {
 public:
  explicit OpenBorder(const Mesh& mesh);

  /// Returns the open half-edges, 3·triangle + k, sorted by (smaller vertex, larger vertex).
  const std::vector<std::uint32_t>& halfEdges() const { return halfEdges_; }
  /// Returns the vertices of the open half-edges, ascending.
  const std::vector<std::uint32_t>& vertices() const { return vertices_; }
  bool isOpen(std::uint32_t vertex) const { return isOpen_[vertex] != 0; }

  /// Finds the open half-edges whose boxes come within `reach` of a point along every axis, in no particular order.
  /// @returns number of half-edges examined: the cost
  std::size_t findNear(Vec3 point, double reach, std::vector<std::uint32_t>& halfEdges) const;

  /// Returns the limit of half-edges to examine in all calls of findNear() of one repair. It is many times what a sound
  /// border needs; only a file with heaps of loose triangles, whose pairs all lie near each other, exceeds it.
  std::size_t maxLooks() const { return kMinLooks + kLooksAVertex * vertices_.size(); }

 private:
  static constexpr std::size_t kMinLooks = 10'000'000, kLooksAVertex = 200;

  struct Found {
    std::vector<std::uint32_t> halfEdges, vertices;
    std::vector<FloatBox> boxes;  ///< of the half-edges, in the same order
  };
  OpenBorder(const Mesh& mesh, Found parts);
  static Found find(const Mesh& mesh);

  std::vector<std::uint32_t> halfEdges_, vertices_;
  std::vector<char> isOpen_;
  BoxTree tree_;
};

}  // namespace qrelief
