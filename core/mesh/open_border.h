// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/box_tree.h"
#include "mesh/topology.h"

namespace qrelief {

/// The edges of one triangle each, and what lies near them.
class OpenBorder {
 public:
  explicit OpenBorder(const Mesh& mesh);

  /// 3·triangle + k, by (smaller vertex, larger vertex).
  const std::vector<std::uint32_t>& halfEdges() const { return halfEdges_; }
  /// Vertices of these, ascending.
  const std::vector<std::uint32_t>& vertices() const { return vertices_; }
  bool isOpen(std::uint32_t vertex) const { return isOpen_[vertex] != 0; }

  /// Open half-edges whose boxes come within `reach` of a point along every axis; in no particular order.
  /// @returns how many were looked at: the cost
  std::size_t findNear(Vec3 point, double reach, std::vector<std::uint32_t>& halfEdges) const;

  /// So many half-edges may be looked at in all calls of findNear() for a repair: many times as many as lie near a
  /// vertex of a sound border. More lie there where a file has loose triangles in a heap, and all pairs of them.
  std::size_t maxLooks() const { return kMinLooks + kLooksAVertex * vertices_.size(); }

 private:
  static constexpr std::size_t kMinLooks = 10'000'000, kLooksAVertex = 200;

  struct Found {
    std::vector<std::uint32_t> halfEdges, vertices;
    std::vector<FloatBox> boxes;  ///< of the half-edges
  };
  OpenBorder(const Mesh& mesh, Found found);
  static Found find(const Mesh& mesh);

  std::vector<std::uint32_t> halfEdges_, vertices_;
  std::vector<char> isOpen_;
  BoxTree tree_;
};

}  // namespace qrelief
