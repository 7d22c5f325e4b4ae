// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numeric>
#include <vector>

#include "mesh/mesh.h"

namespace qrelief {

/// Returns the indices of all triangles of a mesh.
inline std::vector<std::uint32_t> allFacets(const Mesh& mesh) {
  std::vector<std::uint32_t> facets(mesh.triangles.size());
  std::iota(facets.begin(), facets.end(), 0u);
  return facets;
}

}  // namespace qrelief
