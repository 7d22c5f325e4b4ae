// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/solidity.h"

#include <algorithm>

#include "mesh/clean.h"
#include "mesh/collinear.h"
#include "mesh/crossing_segments.h"
#include "mesh/defects.h"
#include "mesh/self_intersection.h"
#include "mesh/topology.h"
#include "message_codes/model.h"

namespace qrelief {
namespace {

/// Groups corners into fans. All triangles that share an edge, however many, join one fan at both of its ends.
CornerFans fansOf(const Mesh& mesh, const EdgeTable& edges) {
  CornerFans fans(mesh);
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (const std::uint32_t other : edges.at(e)) fans.joinAlong(edges.at(e)[0], other);
  return fans;
}

Vec3 middleOf(const Mesh& mesh, std::size_t triangle) {
  return (mesh.corner(triangle, 0) + mesh.corner(triangle, 1) + mesh.corner(triangle, 2)) / 3.0;
}

void findVerticesOfSeveralFans(const Mesh& mesh, const EdgeTable& edges, SolidityReport& report) {
  CornerFans fans = fansOf(mesh, edges);
  constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::uint32_t> fanOf(mesh.positions.size(), kNone);
  std::vector<char> several(mesh.positions.size(), 0);
  for (std::uint32_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
    const std::uint32_t v = mesh.triangles[corner / 3][corner % 3];
    const std::uint32_t fan = fans.find(corner);
    if (fanOf[v] == kNone) fanOf[v] = fan;
    if (fanOf[v] != fan) several[v] = 1;
  }
  report.nonManifoldVertices = static_cast<std::size_t>(std::count(several.begin(), several.end(), 1));
  if (report.nonManifoldVertices > 0)
    report.nonManifoldVertexAt =
        Vec3(mesh.positions[static_cast<std::size_t>(std::find(several.begin(), several.end(), 1) - several.begin())]);
}

void findCollinear(const Mesh& mesh, SolidityReport& report) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& v = mesh.triangles[t];
    if (!collinear(mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]])) continue;
    if (report.degenerateTriangles++ == 0) report.degenerateAt = middleOf(mesh, t);
  }
}

void findDuplicates(const Mesh& mesh, const EdgeTable& edges, SolidityReport& report) {
  if (!mayHaveDuplicates(mesh.triangles, edges)) return;
  std::vector<std::pair<Triangle, std::size_t>> sorted;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle corners = mesh.triangles[t];
    std::sort(corners.begin(), corners.end());
    sorted.emplace_back(corners, t);
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first != sorted[i - 1].first) continue;
    if (report.duplicateTriangles++ == 0) report.duplicateAt = middleOf(mesh, sorted[i].second);
  }
}

/// Finds edges along which both triangles run in the same direction.
void findMisoriented(const Mesh& mesh, const EdgeTable& edges, SolidityReport& report) {
  const auto start = [&](std::uint32_t halfEdge) { return mesh.triangles[halfEdge / 3][halfEdge % 3]; };
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.at(e).size() != 2 || start(edges.at(e)[0]) != start(edges.at(e)[1])) continue;
    if (report.misorientedEdges++ == 0) report.misorientedAt = middleOf(mesh, edges.at(e)[0] / 3);
  }
}

bool anyRepeatsAVertex(const Mesh& mesh) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

}  // namespace

std::vector<SolidityFinding> SolidityReport::findings() const {
  std::vector<SolidityFinding> findings;
  const auto add = [&](std::size_t n, Message what, Vec3 at) {
    if (n > 0) findings.push_back({std::move(what), at});
  };
  add(openEdges, message<"solid-open-edges">(with::count<"count">(openEdges)), openAt);
  add(nonManifoldEdges, message<"solid-crowded-edges">(with::count<"count">(nonManifoldEdges)), nonManifoldEdgeAt);
  add(misorientedEdges, message<"solid-misoriented-edges">(with::count<"count">(misorientedEdges)), misorientedAt);
  add(nonManifoldVertices, message<"solid-touching-vertices">(with::count<"count">(nonManifoldVertices)),
      nonManifoldVertexAt);
  add(degenerateTriangles, message<"solid-triangles-without-area">(with::count<"count">(degenerateTriangles)),
      degenerateAt);
  add(duplicateTriangles, message<"solid-duplicate-triangles">(with::count<"count">(duplicateTriangles)), duplicateAt);
  add(selfIntersections, message<"solid-crossing-pairs">(with::count<"count">(selfIntersections)), selfIntersectionAt);
  if (triangles == 0)
    findings.push_back({message<"solid-no-triangle">(), std::nullopt});
  else if (!(volumeMm3 > 0))
    findings.push_back({message<"solid-inside-out">(with::number<"volumeMm3">(volumeMm3)), std::nullopt});
  return findings;
}

std::vector<Message> SolidityReport::problems() const {
  std::vector<Message> messages;
  for (SolidityFinding& finding : findings()) messages.push_back(std::move(finding.message));
  return messages;
}

Result<SolidityReport> checkSolidity(const Mesh& mesh, std::span<const std::uint32_t> suspects) {
  SolidityReport report;
  report.triangles = mesh.triangles.size();
  report.vertices = mesh.positions.size();
  const EdgeTable edges = buildEdgeTable(mesh.triangles);
  const Defects defects = findDefects(mesh, edges, buildAdjacency(mesh.triangles, edges));
  report.openEdges = defects.openEdges;
  report.openAt = defects.openAt;
  report.nonManifoldEdges = defects.nonManifoldEdges;
  report.nonManifoldEdgeAt = defects.nonManifoldEdgeAt;
  findMisoriented(mesh, edges, report);
  // For a closed surface, walking round its vertices has counted the fans; otherwise corners are joined.
  const bool simple = defects.openEdges + defects.nonManifoldEdges == 0 && !anyRepeatsAVertex(mesh);
  if (simple) {
    report.nonManifoldVertices = defects.nonManifoldVertices;
    report.nonManifoldVertexAt = defects.nonManifoldVertexAt;
  } else {
    findVerticesOfSeveralFans(mesh, edges, report);
  }
  findCollinear(mesh, report);
  findDuplicates(mesh, edges, report);
  report.volumeMm3 = signedVolume(mesh);
  const auto crossings = findSelfIntersections(mesh, suspects);
  QRELIEF_TRY(crossings);
  report.selfIntersections = crossings->size();
  if (!crossings->empty()) report.selfIntersectionAt = crossingPoint(mesh, crossings->front());
  return report;
}

}  // namespace qrelief
