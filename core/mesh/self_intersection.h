// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "mesh/mesh.h"

namespace qrelief {

using TrianglePair = std::array<std::uint32_t, 2>;

/// Number of pairs at which the lists of a model's crossings stop.
inline constexpr std::size_t kMaxCrossingsListed = 1000;

/// Finds pairs of triangles that cross or touch elsewhere than along a shared edge or at a shared vertex, of whichever
/// shells. Pairs are sorted, first index < second. Exact: most neighbours are cleared together, as triangles round one
/// vertex (mesh/vertex_stars.h), most other pairs by a plane between them (mesh/triangle_separation.h), the rest by
/// exact predicates (CGAL, EPICK).
///
/// Shared vertices are recognised by index, so the mesh has to be welded. Two triangles that share an edge count only
/// if they are folded onto each other in one plane. Triangles without area are ignored.
///
/// Cost: a box tree over the suspects; one query for every four suspects and for every other triangle near them; one
/// test for each pair of overlapping boxes. Runs on all cores. Thousands of slivers round one vertex all lie near each
/// other; the search gives up if the pairs grow with the square of the triangles.
/// @param mesh      finite
/// @param suspects  triangles to test against all others, no two the same; empty: all triangles
/// @param limit     stops after this many pairs, always the same ones
/// @param maxLooks  limit of pairs examined in each piece of the work; absent: some hundred for each triangle
/// @returns NoSolution if the search gave up before it found `limit` pairs
Result<std::vector<TrianglePair>> findCrossings(const Mesh& mesh, std::span<const std::uint32_t> suspects = {},
                                                std::size_t limit = kMaxCrossingsListed,
                                                std::optional<std::size_t> maxLooks = {});

/// Finds the pairs of findCrossings() in which both triangles belong to one piece of the mesh, joined by shared
/// vertices. Pieces may overlap and touch each other: together they are a solid, as slicers understand them.
Result<std::vector<TrianglePair>> findSelfIntersections(const Mesh& mesh, std::span<const std::uint32_t> suspects = {},
                                                        std::size_t limit = kMaxCrossingsListed,
                                                        std::optional<std::size_t> maxLooks = {});

}  // namespace qrelief
