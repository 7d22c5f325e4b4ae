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

/// Pairs of triangles that cross or touch other than along a shared edge or at a shared vertex; ordered, first index
/// < second. Exact: most pairs are cleared by a plane between them (mesh/apart.h), the rest goes to exact predicates
/// (CGAL, EPICK).
///
/// What two triangles share goes by vertex index: the mesh has to be welded. Two that share an edge are only counted if
/// folded onto each other in one plane. Triangles without area are passed over.
/// Cost: a box tree over the suspects, a query of it for each four of them and for each other triangle near them, and
/// one test for each pair of overlapping boxes. On all cores. Thousands of slivers round one vertex all lie near each
/// other; the search gives up where the pairs grow with the square of the triangles.
/// @param mesh      finite
/// @param suspects  triangles to test against all others, no two the same; empty = all of the mesh
/// @param limit     stops after so many pairs, always the same ones
/// @param maxLooks  pairs looked at in one of the pieces that the work is cut into; absent: some hundred for each
/// triangle
/// @returns NoSolution if it gave up before it had found `limit` pairs
Result<std::vector<TrianglePair>> findSelfIntersections(const Mesh& mesh, std::span<const std::uint32_t> suspects = {},
                                                        std::size_t limit = 1000,
                                                        std::optional<std::size_t> maxLooks = {});

}  // namespace qrelief
