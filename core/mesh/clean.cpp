// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/clean.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "math/tolerance.h"
#include "mesh/collinear.h"
#include "mesh/touching_shells.h"

namespace qrelief {
namespace {

/// Limit of triangles examined in all rounds of edge flips: some seconds.
constexpr std::size_t kMaxFlipWork = 20'000'000;

bool repeatsAVertex(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

bool isCollinear(const Mesh& mesh, const Triangle& t) {
  return collinear(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
}

template <class T>
void dropMarked(std::vector<T>& items, const std::vector<char>& drop) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (!drop[i]) items[count++] = items[i];
  items.resize(count);
}

/// Drops the marked triangles and records the origin of the rest.
void dropMarked(Mesh& mesh, const std::vector<char>& drop, Cleaning& report) {
  if (std::find(drop.begin(), drop.end(), 1) == drop.end()) return;
  if (report.origin.empty()) {
    report.origin.resize(mesh.triangles.size());
    std::iota(report.origin.begin(), report.origin.end(), 0u);
  }
  dropMarked(report.origin, drop);
  dropMarked(mesh.triangles, drop);
}

bool isClosed(std::span<const Triangle> triangles) {
  const EdgeTable edges = buildEdgeTable(triangles);
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges.at(e).size() != 2) return false;
  return true;
}

/// Returns the edge opposite the middle corner.
std::size_t longestEdge(const Mesh& mesh, const Triangle& t) {
  std::size_t longest = 0;
  double length = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double d = glm::distance(Vec3(mesh.positions[t[k]]), Vec3(mesh.positions[t[(k + 1) % 3]]));
    if (d > length) std::tie(longest, length) = std::pair(k, d);
  }
  return longest;
}

/// Makes one round of flips between slivers and neighbours; no two flips of a round share a triangle. Returns the
/// number of flips.
std::size_t flipSlivers(Mesh& mesh, std::vector<char>& sliver) {
  const Adjacency adjacency = buildAdjacency(mesh.triangles);
  std::vector<char> touched(mesh.triangles.size(), 0);
  std::size_t flips = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!sliver[t] || touched[t]) continue;
    const std::size_t k = longestEdge(mesh, mesh.triangles[t]);
    const std::uint32_t n = adjacency[t][k];
    if (n == kNoTriangle || touched[n]) continue;
    const std::uint32_t middle = mesh.triangles[t][(k + 2) % 3];
    const auto j = static_cast<std::size_t>(sharedEdge(adjacency, n, t));
    const Triangle old = mesh.triangles[n];
    const std::uint32_t apex = old[(j + 2) % 3];
    if (apex == middle) continue;  // folded onto each other: duplicates
    mesh.triangles[t] = {old[j], middle, apex};
    mesh.triangles[n] = {middle, old[(j + 1) % 3], apex};
    for (const std::uint32_t changed : {t, n}) {
      sliver[changed] = isCollinear(mesh, mesh.triangles[changed]);
      touched[changed] = 1;
    }
    ++flips;
  }
  return flips;
}

void removeSlivers(Mesh& mesh, std::vector<char> sliver, Cleaning& report) {
  const auto slivers = static_cast<std::size_t>(std::count(sliver.begin(), sliver.end(), 1));
  if (slivers == 0) return;
  report.degenerate += slivers;
  std::vector<Triangle> without = mesh.triangles;
  dropMarked(without, sliver);
  if (isClosed(without)) {
    dropMarked(mesh, sliver, report);
    return;
  }
  // A round repairs all slivers that are not neighbours of each other, so a chain of n may take more than n rounds, but
  // not n². Without a limit, two slivers in one line would flip each other for ever.
  const std::size_t maxRounds = std::min(slivers * slivers + 1, kMaxFlipWork / mesh.triangles.size() + 1);
  for (std::size_t round = 0; round < maxRounds; ++round)
    if (flipSlivers(mesh, sliver) == 0) break;
  report.mended = slivers - static_cast<std::size_t>(std::count(sliver.begin(), sliver.end(), 1));
  dropMarked(mesh, sliver, report);
}

Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

bool startsAnEvenTurn(const Triangle& t) {
  const Triangle s = sorted(t);
  return t == s || t == Triangle{s[1], s[2], s[0]} || t == Triangle{s[2], s[0], s[1]};
}

/// Returns, for each half-edge, the number of triangles that use its edge.
std::vector<std::uint32_t> countUsers(const EdgeTable& edges) {
  std::vector<std::uint32_t> users(edges.halfEdges.size());
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (const std::uint32_t h : edges.at(e)) users[h] = static_cast<std::uint32_t>(edges.at(e).size());
  return users;
}

/// Returns how many triangles of a group with the same corners stay. Two that face opposite ways are a wall without
/// thickness: both go, unless that leaves an edge with a single triangle (as with a misoriented copy in a closed
/// surface).
std::size_t survivors(std::span<const std::uint32_t> group, std::span<const Triangle> triangles,
                      std::span<const std::uint32_t> users) {
  const auto even = static_cast<std::size_t>(
      std::count_if(group.begin(), group.end(), [&](std::uint32_t t) { return startsAnEvenTurn(triangles[t]); }));
  const bool evenlyUsed = std::all_of(users.begin() + 3 * group[0], users.begin() + 3 * group[0] + 3,
                                      [](std::uint32_t n) { return n % 2 == 0; });
  return 2 * even == group.size() && evenlyUsed ? 0 : 1;
}

void removeDuplicates(Mesh& mesh, const EdgeTable& edges, Cleaning& report) {
  const std::vector<std::uint32_t> users = countUsers(edges);
  std::vector<std::uint32_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(sorted(mesh.triangles[a]), a) < std::pair(sorted(mesh.triangles[b]), b);
  });
  std::vector<char> drop(mesh.triangles.size(), 0);
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    const Triangle corners = sorted(mesh.triangles[order[begin]]);
    while (end < order.size() && sorted(mesh.triangles[order[end]]) == corners) ++end;
    if (end - begin == 1) continue;
    const std::span<const std::uint32_t> group = std::span(order).subspan(begin, end - begin);
    for (const std::uint32_t t : group.subspan(survivors(group, mesh.triangles, users))) {
      drop[t] = 1;
      if (report.duplicates++ == 0) report.duplicateAt = mesh.positions[mesh.triangles[t][0]];
    }
  }
  dropMarked(mesh, drop, report);
}

double heightOver(const Mesh& mesh, const Triangle& t, std::size_t k) {
  const Vec3 a(mesh.positions[t[k]]);
  const Vec3 b(mesh.positions[t[(k + 1) % 3]]);
  const Vec3 c(mesh.positions[t[(k + 2) % 3]]);
  return glm::length(glm::cross(b - a, c - a)) / glm::distance(a, b);
}

/// Drops thin triangles that are attached by one edge to an otherwise complete surface and whose other two edges are
/// open. They are triangles without area whose coordinates have been rounded.
void removeFlaps(Mesh& mesh, const EdgeTable& edges, double maxHeight, Cleaning& report) {
  const std::vector<std::uint32_t> users = countUsers(edges);
  std::vector<char> drop(mesh.triangles.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const bool hangs = users[3 * t + k] > 2 && users[3 * t + (k + 1) % 3] == 1 && users[3 * t + (k + 2) % 3] == 1;
      if (!hangs || heightOver(mesh, mesh.triangles[t], k) > maxHeight) continue;
      drop[t] = 1;
      if (report.degenerate++ == 0) report.degenerateAt = mesh.positions[mesh.triangles[t][0]];
    }
  dropMarked(mesh, drop, report);
}

/// Returns the corner of a half-edge's triangle that is not on it.
std::uint32_t opposite(std::span<const Triangle> triangles, std::uint32_t halfEdge) {
  return triangles[halfEdge / 3][(halfEdge + 2) % 3];
}

}  // namespace

bool mayHaveDuplicates(std::span<const Triangle> triangles, const EdgeTable& edges) {
  // Every edge of a repeated triangle has two or more triangles, and one of them is the twin.
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto users = edges.at(e);
    if (users.size() > 2) return true;
    if (users.size() == 2 && opposite(triangles, users[0]) == opposite(triangles, users[1])) return true;
  }
  return false;
}

Cleaning cleanTriangles(Mesh& mesh) {
  Cleaning report;
  std::vector<char> drop(mesh.triangles.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!repeatsAVertex(mesh.triangles[t])) continue;
    drop[t] = 1;
    if (report.degenerate++ == 0) report.degenerateAt = mesh.positions[mesh.triangles[t][0]];
  }
  dropMarked(mesh, drop, report);

  std::vector<char> sliver(mesh.triangles.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!isCollinear(mesh, mesh.triangles[t])) continue;
    sliver[t] = 1;
    if (!report.degenerateAt) report.degenerateAt = mesh.positions[mesh.triangles[t][0]];
  }
  removeSlivers(mesh, std::move(sliver), report);

  report.edges = buildEdgeTable(mesh.triangles);
  if (!mayHaveDuplicates(mesh.triangles, report.edges)) return report;
  if (separateTouchingShells(mesh, report.edges) > 0) report.edges = buildEdgeTable(mesh.triangles);
  removeDuplicates(mesh, report.edges, report);
  report.edges = buildEdgeTable(mesh.triangles);
  const std::size_t before = mesh.triangles.size();
  removeFlaps(mesh, report.edges, kFlapHeight * boundingBox(mesh).diagonal(), report);
  if (mesh.triangles.size() < before) report.edges = buildEdgeTable(mesh.triangles);
  return report;
}

}  // namespace qrelief
