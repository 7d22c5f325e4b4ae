// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.h"

/// What makes a solid, by counting and comparing, without the code that is tested.
namespace qrelief {

/// The mesh in a binary STL file, corners of equal position made one; nothing else is done to it.
Mesh meshOfStl(std::span<const std::uint8_t> bytes);

/// What is wrong with a closed surface, in words; empty if nothing is: every edge in two triangles that run along it
/// both ways, the triangles at each vertex one fan, none without area, no two with the same corners.
std::string surfaceProblems(const Mesh& mesh);

/// Facets of `mesh` that are no facets of `original`, by the bits of their corners' positions.
std::vector<std::uint32_t> facetsNotIn(const Mesh& mesh, const Mesh& original);

/// Pairs of triangles, one of them a suspect, that have a point in common other than along what they share; by exact
/// predicates, all pairs whose boxes meet. Vertices are the same if their indices are.
std::size_t countCrossings(const Mesh& mesh, const std::vector<std::uint32_t>& suspects);

}  // namespace qrelief
