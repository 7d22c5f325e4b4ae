// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/result.h"
#include "mesh/mesh.h"

namespace qrelief {

inline constexpr std::size_t kMaxHoleEdges = 300;  ///< larger holes stay open: the cost grows with the third power

/// Report of fillHoles().
struct HoleFilling {
  std::size_t filled = 0;
  double largestFilledMm = 0;  ///< diameter
  Vec3 filledAt{0};            ///< a corner of the largest filled hole
  std::size_t tooLarge = 0;    ///< holes left open: too large, or too many edges
  double largestLeftMm = 0;
  std::size_t largestLeftEdges = 0;
  Vec3 leftAt{0};
  std::size_t blocked = 0;  ///< holes whose patch would cross or double the surface
  Vec3 blockedAt{0};
  std::vector<std::uint32_t> beside;  ///< for each added triangle, in order: a triangle at the border of its hole
};

/// Fills small holes, that is, simple loops of open edges, and holes of any size where a single triangle is missing.
/// Each patch minimises its sharpest fold, then its area [Liepa 2003, after Barequet and Sharir 1995], and adds no
/// vertex. A patch that would cross the surface, double a triangle or give an edge a third triangle is undone. A
/// surface with more than a thousand loops is in pieces rather than full of holes: nothing is filled or counted.
///
/// Cost: O(e³) for a hole of e edges, and a search for crossings of the new triangles.
/// @param mesh           consistently oriented
/// @param maxDiameterMm  diameter of the largest hole of more than three edges to fill: the distance between its two
///                       farthest corners
/// @returns an error only if the exact predicates fail
Result<HoleFilling> fillHoles(Mesh& mesh, double maxDiameterMm);

}  // namespace qrelief
