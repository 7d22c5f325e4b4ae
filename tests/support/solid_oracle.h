// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.h"

/// Checks of a solid by counting and comparing, without the code under test.
namespace qrelief {

/// Reads the mesh in a binary STL file and merges corners of equal position; changes nothing else.
Mesh meshOfStl(std::span<const std::uint8_t> bytes);

/// Describes what is wrong with a closed surface; empty if nothing is. In a correct one every edge has two triangles
/// that run along it in opposite directions, the triangles at each vertex form one fan, none lacks area, and no two
/// have the same corners.
std::string surfaceProblems(const Mesh& mesh);

/// Returns the facets of `mesh` that are no facets of `original`, compared by the bits of their corners' positions.
std::vector<std::uint32_t> facetsNotIn(const Mesh& mesh, const Mesh& original);

/// Counts pairs of triangles, one of them a suspect, that have a point in common other than along the vertices or edges
/// they share. Tests all pairs whose boxes meet by exact predicates. Vertices are the same if their indices are.
std::size_t countCrossings(const Mesh& mesh, const std::vector<std::uint32_t>& suspects);

}  // namespace qrelief
