// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/corner_fans.h"

#include <algorithm>
#include <numeric>

namespace qrelief {

CornerFans::CornerFans(const Mesh& mesh) : mesh_(mesh), parent_(3 * mesh.triangles.size()) {
  std::iota(parent_.begin(), parent_.end(), 0u);
}

std::uint32_t CornerFans::find(std::uint32_t corner) {
  while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
  return corner;
}

std::uint32_t CornerFans::cornerAt(std::uint32_t halfEdge, std::uint32_t vertex) const {
  const Triangle& t = mesh_.triangles[halfEdge / 3];
  return halfEdge - halfEdge % 3 + (t[0] == vertex ? 0u : t[1] == vertex ? 1u : 2u);
}

void CornerFans::joinAlong(std::uint32_t halfEdge, std::uint32_t other) {
  const Triangle& t = mesh_.triangles[halfEdge / 3];
  for (const std::uint32_t vertex : {t[halfEdge % 3], t[(halfEdge + 1) % 3]}) {
    const std::uint32_t a = find(cornerAt(halfEdge, vertex)), b = find(cornerAt(other, vertex));
    parent_[std::max(a, b)] = std::min(a, b);
  }
}

}  // namespace qrelief
