// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/t_junctions.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "mesh/open_border.h"

namespace qrelief {
namespace {

/// Three suffice: a round splits one edge of a triangle, and each new triangle has fewer open edges than the old one.
constexpr int kMaxRounds = 3;

/// A vertex on the open edge k of a triangle.
struct Junction {
  std::uint32_t triangle, edge;
  double along;  // 0 … 1
  std::uint32_t vertex;
  double gap;
};

/// Adds the junctions at one vertex. Skips edges of slivers, which a split could turn over.
void addJunctions(const Mesh& mesh, std::span<const std::uint32_t> nearby, std::uint32_t vertex, double tolerance,
                  std::vector<Junction>& junctions) {
  const Vec3 p(mesh.positions[vertex]);
  for (const std::uint32_t halfEdge : nearby) {
    const std::uint32_t t = halfEdge / 3, k = halfEdge % 3;
    const Triangle& corners = mesh.triangles[t];
    if (std::find(corners.begin(), corners.end(), vertex) != corners.end()) continue;
    const Vec3 a = mesh.corner(t, static_cast<int>(k));
    const Vec3 b = mesh.corner(t, static_cast<int>((k + 1) % 3));
    const Vec3 c = mesh.corner(t, static_cast<int>((k + 2) % 3));
    const double length = glm::distance(a, b);
    const double along = glm::dot(p - a, b - a) / (length * length);
    const double gap = glm::distance(p, a + (b - a) * along);
    const double height = glm::length(glm::cross(b - a, c - a)) / length;
    if (gap <= tolerance && along * length > tolerance && (1 - along) * length > tolerance && height > 2 * tolerance)
      junctions.push_back({t, k, along, vertex, gap});
  }
}

/// Returns junctions sorted by triangle, edge and place along the edge.
/// @param bodyOf    body of each triangle; empty: one body
/// @param cutShort  set to true if there is too much to examine
std::vector<Junction> findJunctions(const Mesh& mesh, double tolerance, std::span<const std::uint32_t> bodyOf,
                                    bool& cutShort) {
  const OpenBorder border(mesh);
  std::vector<Junction> junctions;
  std::vector<std::uint32_t> nearby, bodyOfVertex(bodyOf.empty() ? 0 : mesh.positions.size(), 0);
  for (std::size_t t = 0; t < bodyOf.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t]) bodyOfVertex[v] = bodyOf[t];
  std::size_t looks = 0;
  for (const std::uint32_t v : border.vertices()) {
    looks += border.findNear(Vec3(mesh.positions[v]), tolerance, nearby);
    if (!bodyOf.empty())
      std::erase_if(nearby, [&](std::uint32_t halfEdge) { return bodyOf[halfEdge / 3] != bodyOfVertex[v]; });
    addJunctions(mesh, nearby, v, tolerance, junctions);
    cutShort = looks > border.maxLooks();
    if (cutShort) break;
  }
  std::sort(junctions.begin(), junctions.end(), [](const Junction& a, const Junction& b) {
    return std::tie(a.triangle, a.edge, a.along, a.vertex) < std::tie(b.triangle, b.edge, b.along, b.vertex);
  });
  return junctions;
}

/// Splits one edge of each triangle that has junctions.
void splitOnce(Mesh& mesh, std::span<const Junction> junctions, TJunctionSplit& result) {
  for (std::size_t begin = 0, end = 0; begin < junctions.size(); begin = end) {
    const std::uint32_t t = junctions[begin].triangle;
    const std::uint32_t edge = junctions[begin].edge;
    while (end < junctions.size() && junctions[end].triangle == t) ++end;
    const Triangle whole = mesh.triangles[t];
    const std::uint32_t apex = whole[(edge + 2) % 3];
    std::uint32_t from = whole[edge];
    for (std::size_t i = begin; i < end && junctions[i].edge == edge; ++i) {
      mesh.triangles.push_back({from, junctions[i].vertex, apex});
      result.origin.push_back(result.origin[t]);
      from = junctions[i].vertex;
      if (result.vertices++ == 0) result.at = Vec3(mesh.positions[from]);
      result.largestGapMm = std::max(result.largestGapMm, junctions[i].gap);
    }
    mesh.triangles[t] = {from, whole[(edge + 1) % 3], apex};
  }
}

}  // namespace

TJunctionSplit splitAtTJunctions(Mesh& mesh, double toleranceMm, std::span<const std::uint32_t> bodyOfTriangle) {
  TJunctionSplit result;
  result.origin.resize(mesh.triangles.size());
  std::iota(result.origin.begin(), result.origin.end(), 0u);
  Mesh split = mesh;
  for (int round = 0; round < kMaxRounds && !result.cutShort; ++round) {
    std::vector<std::uint32_t> bodyOf;
    if (!bodyOfTriangle.empty())
      for (const std::uint32_t t : result.origin) bodyOf.push_back(bodyOfTriangle[t]);
    const std::vector<Junction> junctions = findJunctions(split, toleranceMm, bodyOf, result.cutShort);
    if (junctions.empty()) break;
    splitOnce(split, junctions, result);
  }
  if (result.vertices == 0 || OpenBorder(split).halfEdges().size() >= OpenBorder(mesh).halfEdges().size()) {
    TJunctionSplit nothing;
    nothing.cutShort = result.cutShort;
    return nothing;
  }
  mesh = std::move(split);
  return result;
}

}  // namespace qrelief
