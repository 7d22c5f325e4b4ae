// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/solidity.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

#include "mesh/collinear.h"
#include "mesh/self_intersection.h"

namespace qrelief {
namespace {

struct HalfEdge {
  std::uint64_t key;   // smaller vertex, larger vertex
  std::uint32_t slot;  // 3·triangle + edge
  bool forward;        // from the smaller vertex to the larger
};

std::vector<HalfEdge> sortedHalfEdges(const Mesh& mesh) {
  std::vector<HalfEdge> edges(3 * mesh.triangles.size());
  for (std::uint32_t slot = 0; slot < edges.size(); ++slot) {
    const Triangle& t = mesh.triangles[slot / 3];
    const std::uint64_t a = t[slot % 3], b = t[(slot + 1) % 3];
    edges[slot] = {std::min(a, b) << 32 | std::max(a, b), slot, a < b};
  }
  std::sort(edges.begin(), edges.end(),
            [](const HalfEdge& x, const HalfEdge& y) { return x.key != y.key ? x.key < y.key : x.slot < y.slot; });
  return edges;
}

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

/// Counts the edges' defects; triangles that share an edge come into one fan at both of its ends.
void checkEdges(const Mesh& mesh, std::span<const HalfEdge> edges, Fans& fans, SolidityReport& report) {
  const auto cornerAt = [&](std::uint32_t slot, std::uint32_t vertex) {
    const std::uint32_t first = slot - slot % 3;
    const Triangle& t = mesh.triangles[slot / 3];
    return first + (t[0] == vertex ? 0u : t[1] == vertex ? 1u : 2u);
  };
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin + 1;
    while (end < edges.size() && edges[end].key == edges[begin].key) ++end;
    if (end - begin == 1) ++report.openEdges;
    if (end - begin > 2) ++report.nonManifoldEdges;
    if (end - begin == 2 && edges[begin].forward == edges[begin + 1].forward) ++report.misorientedEdges;
    const auto low = static_cast<std::uint32_t>(edges[begin].key >> 32);
    const auto high = static_cast<std::uint32_t>(edges[begin].key);
    for (std::size_t k = begin + 1; k < end; ++k) {
      fans.join(cornerAt(edges[begin].slot, low), cornerAt(edges[k].slot, low));
      fans.join(cornerAt(edges[begin].slot, high), cornerAt(edges[k].slot, high));
    }
    begin = end;
  }
}

std::size_t countVerticesOfSeveralFans(const Mesh& mesh, Fans& fans) {
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

std::size_t countDuplicates(const Mesh& mesh) {
  std::vector<Triangle> sorted = mesh.triangles;
  for (Triangle& t : sorted) std::sort(t.begin(), t.end());
  std::sort(sorted.begin(), sorted.end());
  return static_cast<std::size_t>(sorted.end() - std::unique(sorted.begin(), sorted.end()));
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
  Fans fans(3 * mesh.triangles.size());
  checkEdges(mesh, sortedHalfEdges(mesh), fans, report);
  report.nonManifoldVertices = countVerticesOfSeveralFans(mesh, fans);
  report.degenerateTriangles = countCollinear(mesh);
  report.duplicateTriangles = countDuplicates(mesh);
  report.volumeMm3 = signedVolume(mesh);
  const auto crossings = findSelfIntersections(mesh, suspects);
  if (!crossings) return tl::unexpected(crossings.error());
  report.selfIntersections = crossings->size();
  return report;
}

}  // namespace qrelief
