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

  /// Triangles with an open edge whose boxes come within `reach` of a point along every axis; in no particular order.
  void findNear(Vec3 point, double reach, std::vector<std::uint32_t>& triangles) const;

 private:
  struct Found {
    std::vector<std::uint32_t> halfEdges, vertices, triangles;
  };
  OpenBorder(const Mesh& mesh, Found found);
  static Found find(const Mesh& mesh);

  std::vector<std::uint32_t> halfEdges_, vertices_;
  std::vector<char> isOpen_;
  BoxTree tree_;
};

}  // namespace qrelief
