// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.h"

namespace qrelief {

/// The fans of a mesh: triangles round a vertex that are joined along edges. Corner k of triangle t has number 3·t + k;
/// corners of one fan have one representative.
class CornerFans {
 public:
  /// Starts with every corner alone.
  explicit CornerFans(const Mesh& mesh);

  /// Joins the triangles of two half-edges (mesh/topology.h) of the same edge, at both of its ends.
  void joinAlong(std::uint32_t halfEdge, std::uint32_t other);

  /// Returns the lowest corner of a corner's fan.
  std::uint32_t find(std::uint32_t corner);

 private:
  std::uint32_t cornerAt(std::uint32_t halfEdge, std::uint32_t vertex) const;

  const Mesh& mesh_;
  std::vector<std::uint32_t> parent_;
};

}  // namespace qrelief
