// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "carving/outline.h"
#include "carving/outlined_pockets.h"
#include "math/frame.h"
#include "mesh/mesh.h"

namespace qrelief {

inline constexpr std::uint32_t kNoFacet = 0xffffffffu;

/// The facets that carving may change, projected on the QR plane: a planar triangulation, possibly in several pieces
/// and with holes.
struct Footprint {
  struct Edge {
    std::uint32_t a = 0, b = 0;                       ///< local vertices
    std::uint32_t left = kNoFacet, right = kNoFacet;  ///< local facets at a → b; right = kNoFacet on the rim
  };
  std::vector<std::uint32_t> facets;    ///< mesh triangles, ascending
  std::vector<std::uint32_t> vertices;  ///< local vertex → mesh vertex, ascending
  std::vector<Vec2> points;             ///< local vertex → plane coordinates, mm
  std::vector<Triangle> corners;        ///< local facet → local vertices, counter-clockwise
  std::vector<char> reshaped;           ///< local facet → true if its corners differ from the mesh triangle's
  std::vector<Edge> edges;
};

/// Finds the facets of the patch within `marginMm` of a carved submodule or of the label, and flips needles among them.
///
/// Cost: O(patch + submodules covered).
/// @returns NoSolution if the eye sees one of them from behind
Result<Footprint> findFootprint(const Mesh& mesh, const ProjectionFrame& frame, std::span<const std::uint32_t> patch,
                                const DepthLevels& levels, double marginMm, const OutlinedPockets& label = {});

}  // namespace qrelief
