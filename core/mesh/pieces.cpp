// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/pieces.h"

#include <algorithm>
#include <numeric>

namespace qrelief {

std::vector<std::uint32_t> piecesOf(const Mesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto find = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t other : {t[1], t[2]}) {
      const std::uint32_t a = find(t[0]), b = find(other);
      parent[std::max(a, b)] = std::min(a, b);
    }
  for (std::uint32_t v = 0; v < parent.size(); ++v) parent[v] = find(v);
  return parent;
}

}  // namespace qrelief
