// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace qrelief {

inline constexpr std::uint32_t kNoTriangle = 0xffffffffu;

/// The half-edge structure of a triangle mesh: for each triangle `t` and edge `k` (from corner k to
/// corner k+1 mod 3) the triangle on the other side, or kNoTriangle where the edge is open or shared by
/// more than two triangles.
using Adjacency = std::vector<std::array<std::uint32_t, 3>>;

/// Cost: one sort of the 3·T half-edges, without hashing, so the result depends on nothing but the input.
Adjacency buildAdjacency(std::span<const Triangle> triangles);

/// Which edge of `across` is shared with `triangle`; precondition: they share one.
int sharedEdge(const Adjacency& adjacency, std::uint32_t across, std::uint32_t triangle);

}  // namespace qrelief
