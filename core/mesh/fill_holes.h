// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/result.h"
#include "mesh/mesh.h"

namespace qrelief {

inline constexpr std::size_t kMaxHoleEdges = 300;  ///< larger holes stay: the search grows with the third power

/// What fillHoles() did and what it left.
struct HoleFilling {
  std::size_t filled = 0;
  double largestFilledMm = 0;  ///< diameter
  Vec3 filledAt{0};            ///< a corner of the largest filled
  std::size_t tooLarge = 0;    ///< left because of their size or number of edges
  double largestLeftMm = 0;
  std::size_t largestLeftEdges = 0;
  Vec3 leftAt{0};
  std::size_t blocked = 0;  ///< left because any patch, or the one found, would cross or double the surface
  Vec3 blockedAt{0};
  std::vector<std::uint32_t> beside;  ///< for each triangle added, in order: one of the triangles around its hole
};

/// Fills small holes: simple loops of open edges, each triangulated so that the sharpest fold, then the area, is least
/// [Liepa 2003, after Barequet and Sharir 1995]; no vertex is added. A patch that would cross the surface, double a
/// triangle or give an edge a third triangle is taken back. A surface with more than a thousand loops is in pieces
/// rather than full of holes: nothing is filled or counted.
///
/// Cost: O(e³) for a hole of e edges, and a search for crossings of the new triangles.
/// @param mesh           consistently oriented
/// @param maxDiameterMm  of a hole to be filled: the distance of its two farthest corners
/// @returns an error only if the exact predicates fail
Result<HoleFilling> fillHoles(Mesh& mesh, double maxDiameterMm);

}  // namespace qrelief
