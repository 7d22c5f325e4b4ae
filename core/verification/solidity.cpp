// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/solidity.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

#include "mesh/clean.h"
#include "mesh/collinear.h"
#include "mesh/defects.h"
#include "mesh/self_intersection.h"

namespace qrelief {
namespace {

/// Sets of triangle corners, joined as they turn out to belong to one fan.
class Fans {
 public:
  explicit Fans(std::size_t corners) : parent_(corners) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t find(std::uint32_t corner) {
    while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Triangles that share an edge, however many, come into one fan at both of its ends.
Fans fansOf(const Mesh& mesh, const EdgeTable& edges) {
  Fans fans(3 * mesh.triangles.size());
  const auto cornerAt = [&](std::uint32_t halfEdge, std::uint32_t vertex) {
    const Triangle& t = mesh.triangles[halfEdge / 3];
    return halfEdge - halfEdge % 3 + (t[0] == vertex ? 0u : t[1] == vertex ? 1u : 2u);
  };
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::uint32_t first = edges.at(e)[0];
    const Triangle& t = mesh.triangles[first / 3];
    for (const std::uint32_t other : edges.at(e))
      for (const std::uint32_t vertex : {t[first % 3], t[(first + 1) % 3]})
        fans.join(cornerAt(first, vertex), cornerAt(other, vertex));
  }
  return fans;
}

std::size_t countVerticesOfSeveralFans(const Mesh& mesh, const EdgeTable& edges) {
  Fans fans = fansOf(mesh, edges);
  constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::uint32_t> fanOf(mesh.positions.size(), kNone);
  std::vector<char> several(mesh.positions.size(), 0);
  for (std::uint32_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
    const std::uint32_t v = mesh.triangles[corner / 3][corner % 3];
    const std::uint32_t fan = fans.find(corner);
    if (fanOf[v] == kNone) fanOf[v] = fan;
    if (fanOf[v] != fan) several[v] = 1;
  }
  return static_cast<std::size_t>(std::count(several.begin(), several.end(), 1));
}

std::size_t countCollinear(const Mesh& mesh) {
  return static_cast<std::size_t>(std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    return collinear(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
  }));
}

std::size_t countDuplicates(const Mesh& mesh, const EdgeTable& edges) {
  if (!mayHaveDuplicates(mesh.triangles, edges)) return 0;
  std::vector<Triangle> sorted = mesh.triangles;
  for (Triangle& t : sorted) std::sort(t.begin(), t.end());
  std::sort(sorted.begin(), sorted.end());
  return static_cast<std::size_t>(sorted.end() - std::unique(sorted.begin(), sorted.end()));
}

/// Edges whose two triangles run along them in the same direction.
std::size_t countMisoriented(const Mesh& mesh, const EdgeTable& edges) {
  const auto start = [&](std::uint32_t halfEdge) { return mesh.triangles[halfEdge / 3][halfEdge % 3]; };
  std::size_t count = 0;
  for (std::size_t e = 0; e < edges.size(); ++e)
    count += edges.at(e).size() == 2 && start(edges.at(e)[0]) == start(edges.at(e)[1]);
  return count;
}

bool anyRepeatsAVertex(const Mesh& mesh) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

}  // namespace

std::vector<std::string> SolidityReport::problems() const {
  std::vector<std::string> words;
  const auto count = [&](std::size_t n, const char* one, const char* many) {
    if (n > 0) words.push_back(fmt::format("{} {}", n, n == 1 ? one : many));
  };
  count(openEdges, "open edge", "open edges");
  count(nonManifoldEdges, "edge with more than two triangles", "edges with more than two triangles");
  count(misorientedEdges, "edge between triangles that face opposite ways",
        "edges between triangles that face opposite ways");
  count(nonManifoldVertices, "vertex where parts touch in a point only", "vertices where parts touch in a point only");
  count(degenerateTriangles, "triangle without area", "triangles without area");
  count(duplicateTriangles, "duplicate triangle", "duplicate triangles");
  count(selfIntersections, "pair of triangles that cross", "pairs of triangles that cross");
  if (triangles == 0) {
    words.push_back("no triangle");
  } else if (!(volumeMm3 > 0)) {
    words.push_back(fmt::format("inside out: its volume is {:.6g} mm³", volumeMm3));
  }
  return words;
}

Result<SolidityReport> checkSolidity(const Mesh& mesh, std::span<const std::uint32_t> suspects) {
  SolidityReport report;
  report.triangles = mesh.triangles.size();
  report.vertices = mesh.positions.size();
  const EdgeTable edges = buildEdgeTable(mesh.triangles);
  const Defects defects = findDefects(mesh, edges, buildAdjacency(mesh.triangles, edges));
  report.openEdges = defects.openEdges;
  report.nonManifoldEdges = defects.nonManifoldEdges;
  report.misorientedEdges = countMisoriented(mesh, edges);
  // A closed surface's fans are counted by walking round its vertices, others by joining corners.
  const bool simple = defects.openEdges + defects.nonManifoldEdges == 0 && !anyRepeatsAVertex(mesh);
  report.nonManifoldVertices = simple ? defects.nonManifoldVertices : countVerticesOfSeveralFans(mesh, edges);
  report.degenerateTriangles = countCollinear(mesh);
  report.duplicateTriangles = countDuplicates(mesh, edges);
  report.volumeMm3 = signedVolume(mesh);
  const auto crossings = findSelfIntersections(mesh, suspects);
  if (!crossings) return tl::unexpected(crossings.error());
  report.selfIntersections = crossings->size();
  return report;
}

}  // namespace qrelief
