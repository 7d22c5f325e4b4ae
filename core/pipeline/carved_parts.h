// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace qrelief {

/// Returns the part of every triangle of a carved mesh. Kept facets stay in their part; facets created by carving all
/// belong to part `carved`.
///
/// Kept facets come first, in their old order and unchanged bit for bit (carving/embed.h), so a walk along both
/// meshes matches them by equal corners. Cost: O(T).
/// @param partOf  part of each triangle of `before`; empty: one part only, and the result is empty, too
/// @param kept    triangles of `after` that come from `before`
/// @param carved  part of the new triangles
std::vector<std::uint32_t> partsAfterCarving(const Mesh& before, std::span<const std::uint32_t> partOf,
                                             const Mesh& after, std::size_t kept, std::uint32_t carved);

}  // namespace qrelief
