// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/refine.h"

#include <cassert>

#include "mesh/topology.h"

namespace qrelief {
namespace {

constexpr std::uint32_t kWhole = 0xffffffffu;  // an edge without a midpoint

using Middles = std::array<std::uint32_t, 3>;  // vertices at the midpoints of the edges 01, 12, 20

/// Cuts a facet at the midpoints of its edges into two, three or four.
void cut(const Triangle& t, const Middles& m, std::vector<Triangle>& out) {
  const auto count = (m[0] != kWhole) + (m[1] != kWhole) + (m[2] != kWhole);
  if (count == 0) {
    out.push_back(t);
  } else if (count == 3) {
    out.insert(out.end(), {{t[0], m[0], m[2]}, {m[0], t[1], m[1]}, {m[2], m[1], t[2]}, {m[0], m[1], m[2]}});
  } else if (count == 1) {
    const std::size_t k = m[0] != kWhole ? 0 : m[1] != kWhole ? 1 : 2;
    const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
    out.insert(out.end(), {{a, m[k], c}, {m[k], b, c}});
  } else {
    // Rotate the corners so that the uncut edge is c–a. Cut off corner b, then cut the rest along m(ab)–c.
    const std::size_t k = m[0] == kWhole ? 1 : m[1] == kWhole ? 2 : 0;
    const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
    const std::uint32_t ab = m[k], bc = m[(k + 1) % 3];
    out.insert(out.end(), {{ab, b, bc}, {a, ab, c}, {ab, bc, c}});
  }
}

}  // namespace

Mesh refineEdges(Mesh mesh, double longestMm, std::size_t maxTriangles) {
  assert(longestMm > 0);
  const auto isLong = [&](std::uint32_t a, std::uint32_t b) {
    return glm::distance(Vec3(mesh.positions[a]), Vec3(mesh.positions[b])) > longestMm;
  };
  for (;;) {
    std::size_t longSides = 0;
    for (const Triangle& t : mesh.triangles)
      for (std::size_t k = 0; k < 3; ++k) longSides += isLong(t[k], t[(k + 1) % 3]) ? 1 : 0;
    if (longSides == 0 || mesh.triangles.size() + longSides > maxTriangles) return mesh;

    const EdgeTable edges = buildEdgeTable(mesh.triangles);
    std::vector<Middles> middles(mesh.triangles.size(), {kWhole, kWhole, kWhole});
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const std::uint32_t first = edges.at(e)[0];
      const Triangle& t = mesh.triangles[first / 3];
      const std::uint32_t a = t[first % 3], b = t[(first % 3 + 1) % 3];
      if (!isLong(a, b)) continue;
      const auto middle = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.emplace_back((Vec3(mesh.positions[a]) + Vec3(mesh.positions[b])) / 2.0);
      for (const std::uint32_t h : edges.at(e)) middles[h / 3][h % 3] = middle;
    }
    std::vector<Triangle> cutTriangles;
    cutTriangles.reserve(mesh.triangles.size() + longSides);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) cut(mesh.triangles[t], middles[t], cutTriangles);
    mesh.triangles = std::move(cutTriangles);
  }
}

}  // namespace qrelief
