// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "embedding/depth_levels.h"
#include "math/frame.h"
#include "mesh/mesh.h"

namespace qrelief {

inline constexpr std::uint32_t kNoFacet = 0xffffffffu;

/// The facets that carving may touch, projected on the QR plane: a planar triangulation, possibly of several pieces
/// and with holes.
struct Footprint {
  struct Edge {
    std::uint32_t a = 0, b = 0;                       ///< local vertices
    std::uint32_t left = kNoFacet, right = kNoFacet;  ///< local facets beside a → b; right = kNoFacet on the rim
  };
  std::vector<std::uint32_t> facets;    ///< mesh triangles, ascending
  std::vector<std::uint32_t> vertices;  ///< local vertex → mesh vertex, ascending
  std::vector<Vec2> points;             ///< local vertex → plane coordinates, mm
  std::vector<Triangle> corners;        ///< local facet → local vertices, counter-clockwise
  std::vector<char> reshaped;           ///< local facet → its corners are no longer those of the mesh's triangle
  std::vector<Edge> edges;
};

/// Facets of the patch that come within `marginMm` of a carved submodule, needles among them flipped.
///
/// Cost: O(patch + submodules covered).
/// @returns NoSolution if one of them is not seen from its front
Result<Footprint> findFootprint(const Mesh& mesh, const ProjectionFrame& frame, std::span<const std::uint32_t> patch,
                                const DepthLevels& levels, double marginMm);

}  // namespace qrelief
