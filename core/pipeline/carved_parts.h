// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace qrelief {

/// The part of every triangle of a carved mesh: kept facets stay in theirs, those that carving made belong to one.
///
/// Kept facets come first and in their old order (embedding/embed.h), bit for bit: walking both meshes at once, by
/// equal corners, finds each again. Cost: O(T).
/// @param partOf  part of each triangle of `before`; empty: there is one only, and so is the answer
/// @param kept    triangles of `after` that come from `before`
/// @param carved  part of the new ones
std::vector<std::uint32_t> partsAfterCarving(const Mesh& before, std::span<const std::uint32_t> partOf,
                                             const Mesh& after, std::size_t kept, std::uint32_t carved);

}  // namespace qrelief
