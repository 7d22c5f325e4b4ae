// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "mesh/mesh.h"

namespace qrelief {

/// A defect that keeps a mesh from being a solid.
struct SolidityFinding {
  Message message;         ///< the defect and its count; to be quoted within another message
  std::optional<Vec3> at;  ///< place of the first, mm; none if it concerns the whole mesh
};

/// Defects that a slicer would find in a mesh read back from a file.
struct SolidityReport {
  std::size_t triangles = 0, vertices = 0;
  std::size_t openEdges = 0, nonManifoldEdges = 0, misorientedEdges = 0, nonManifoldVertices = 0;
  std::size_t degenerateTriangles = 0, duplicateTriangles = 0;
  std::size_t selfIntersections = 0;  ///< pairs of triangles, among the suspects only
  double volumeMm3 = 0;
  /// Place of the first defect of each kind; valid only if there is one.
  Vec3 openAt{0}, nonManifoldEdgeAt{0}, misorientedAt{0}, nonManifoldVertexAt{0}, degenerateAt{0}, duplicateAt{0},
      selfIntersectionAt{0};

  bool closed() const { return openEdges == 0; }
  bool manifold() const { return nonManifoldEdges + misorientedEdges + nonManifoldVertices == 0; }
  bool solid() const {
    return closed() && manifold() && degenerateTriangles + duplicateTriangles + selfIntersections == 0 && volumeMm3 > 0;
  }
  std::vector<SolidityFinding> findings() const;  ///< empty if solid
  std::vector<Message> problems() const;          ///< the same without places
};

/// Checks a mesh whose vertices are welded by equal position. Degenerate = collinear corners, by an exact test.
/// @param suspects  triangles tested for self-intersection against all others; empty = all
Result<SolidityReport> checkSolidity(const Mesh& mesh, std::span<const std::uint32_t> suspects = {});

}  // namespace qrelief
