// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.h"

namespace qrelief {

/// Returns the piece of each vertex: the lowest vertex that can be reached over triangles. Cost: O(T).
std::vector<std::uint32_t> piecesOf(const Mesh& mesh);

}  // namespace qrelief
