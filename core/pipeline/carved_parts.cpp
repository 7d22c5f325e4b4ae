// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/carved_parts.h"

#include <cassert>

namespace qrelief {
namespace {

bool sameCorners(const Mesh& a, std::size_t s, const Mesh& b, std::size_t t) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a.positions[a.triangles[s][k]] != b.positions[b.triangles[t][k]]) return false;
  return true;
}

}  // namespace

std::vector<std::uint32_t> partsAfterCarving(const Mesh& before, std::span<const std::uint32_t> partOf,
                                             const Mesh& after, std::size_t kept, std::uint32_t carved) {
  if (partOf.empty()) return {};
  std::vector<std::uint32_t> parts(after.triangles.size(), carved);
  std::size_t old = 0;
  for (std::size_t t = 0; t < kept; ++t, ++old) {
    while (old < before.triangles.size() && !sameCorners(before, old, after, t)) ++old;
    assert(old < before.triangles.size());
    if (old == before.triangles.size()) break;
    parts[t] = partOf[old];
  }
  return parts;
}

}  // namespace qrelief
