// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "math/tolerance.h"
#include "mesh/crossing_segments.h"
#include "mesh/self_intersection.h"
#include "mesh/touching_shells.h"
#include "mesh/weld.h"

namespace qrelief {
namespace {

std::size_t countEdges(const EdgeTable& edges, bool open) {
  std::size_t count = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) count += open ? edges.at(e).size() == 1 : edges.at(e).size() > 2;
  return count;
}

/// Sets origin[i] to the former origin[step[i]]; an empty step changes nothing.
void follow(std::vector<std::uint32_t>& origin, const std::vector<std::uint32_t>& step) {
  if (step.empty()) return;
  std::vector<std::uint32_t> followed(step.size());
  for (std::size_t i = 0; i < step.size(); ++i) followed[i] = origin[step[i]];
  origin = std::move(followed);
}

void addTo(Cleaning& sum, const Cleaning& more) {
  sum.degenerate += more.degenerate;
  sum.mended += more.mended;
  sum.duplicates += more.duplicates;
  if (!sum.degenerateAt) sum.degenerateAt = more.degenerateAt;
  if (!sum.duplicateAt) sum.duplicateAt = more.duplicateAt;
}

double toleranceFor(const Mesh& mesh, const RepairOptions& options) {
  if (options.weldToleranceMm) return *options.weldToleranceMm;
  const Box3 box = boundingBox(mesh);
  const Vec3 far = glm::max(glm::abs(box.min), glm::abs(box.max));
  return std::max(std::min(kWeldFraction * box.diagonal(), kMaxRepairMoveMm),
                  kWeldFloatSteps * std::numeric_limits<float>::epsilon() * std::max({far.x, far.y, far.z}));
}

std::vector<std::uint32_t> bodiesNow(const Repaired& r, std::span<const std::uint32_t> bodyOfTriangle) {
  std::vector<std::uint32_t> bodies;
  if (bodyOfTriangle.empty()) return bodies;
  for (const std::uint32_t t : r.origin) bodies.push_back(bodyOfTriangle[t]);
  return bodies;
}

/// Welds and splits along open edges.
void closeSeams(Repaired& r, std::span<const std::uint32_t> bodyOfTriangle, const RepairOptions& options,
                EdgeTable& edges) {
  const std::size_t nonManifold = countEdges(edges, false);
  if (options.weldNear) {
    Mesh welded = r.mesh;
    const NearWelding welding = weldNear(welded, r.toleranceMm, bodiesNow(r, bodyOfTriangle));
    r.seamsCutShort |= welding.cutShort;
    Cleaning cleaning = welding.moved > 0 ? cleanTriangles(welded) : Cleaning{};
    if (welding.moved > 0 && countEdges(cleaning.edges, false) <= nonManifold) {
      r.mesh = std::move(welded);
      edges = std::move(cleaning.edges);
      r.welding = welding;
      addTo(r.cleaning, cleaning);
      follow(r.origin, cleaning.origin);
    }
  }
  if (options.splitTJunctions && countEdges(edges, true) > 0) {
    Mesh split = r.mesh;
    TJunctionSplit splitting = splitAtTJunctions(split, r.toleranceMm, bodiesNow(r, bodyOfTriangle));
    r.seamsCutShort |= splitting.cutShort;
    EdgeTable after = buildEdgeTable(split.triangles);
    if (splitting.vertices > 0 && countEdges(after, false) <= nonManifold) {
      r.mesh = std::move(split);
      edges = std::move(after);
      follow(r.origin, splitting.origin);
      r.split = std::move(splitting);
    }
  }
}

/// Fills holes in a consistent mesh and finds its shells anew.
Status closeHoles(Repaired& r, EdgeTable& edges) {
  Result<HoleFilling> filling = fillHoles(r.mesh, r.maxHoleMm);
  QRELIEF_TRY(filling);
  r.filling = std::move(*filling);
  if (r.filling.filled == 0) return {};
  for (const std::uint32_t t : r.filling.beside) r.origin.push_back(r.origin[t]);
  edges = buildEdgeTable(r.mesh.triangles);
  r.adjacency = buildAdjacency(r.mesh.triangles, edges);
  Consistency now = makeConsistent(r.mesh.triangles, r.adjacency);
  const Consistency& before = r.consistency;
  for (std::size_t t = 0; t < before.shells.of.size(); ++t)
    if (before.wasMixed[before.shells.of[t]]) now.wasMixed[now.shells.of[t]] = 1;
  now.turned += before.turned;
  if (before.turnedExample) now.turnedExample = before.turnedExample;
  r.consistency = std::move(now);
  return {};
}

/// Counts crossing pairs, up to a limit, and moves nothing.
Result<Untangling> countCrossings(const Mesh& mesh) {
  const auto pairs = findSelfIntersections(mesh, {}, kMaxCrossingsListed);
  Untangling result;
  result.tooCrowded = !pairs && pairs.error().kind == ErrorKind::NoSolution;
  if (result.tooCrowded) return result;
  QRELIEF_TRY(pairs);
  result.pairs = pairs->size();
  result.atLeast = pairs->size() == kMaxCrossingsListed;
  if (!pairs->empty()) result.at = crossingPoint(mesh, pairs->front());
  result.left = *pairs;
  return result;
}

/// Finds the pairs of triangles that cross or touch, unless the untangling left all of them.
Status listCrossings(Repaired& r) {
  const Untangling& untangling = r.untangling;
  if (r.consistency.shells.count == 1) {
    if (!untangling.tooCrowded && !untangling.atLeast) r.crossings = untangling.left;
    return {};
  }
  auto crossings = findCrossings(r.mesh, {}, kMaxCrossingsListed);
  if (!crossings && crossings.error().kind != ErrorKind::NoSolution) return tl::unexpected(crossings.error());
  r.overlaps.tooCrowded = !crossings;
  if (!crossings) return {};
  const std::vector<std::uint32_t>& shells = r.consistency.shells.of;
  for (const TrianglePair& pair : *crossings)
    if (shells[pair[0]] != shells[pair[1]] && r.overlaps.pairs++ == 0) r.overlaps.at = crossingPoint(r.mesh, pair);
  r.overlaps.atLeast = crossings->size() == kMaxCrossingsListed;
  if (!r.overlaps.atLeast) r.crossings = std::move(*crossings);
  return {};
}

}  // namespace

Result<Repaired> repairMesh(Mesh mesh, std::span<const std::uint32_t> bodyOfTriangle, const RepairOptions& options) {
  Repaired r;
  r.mesh = std::move(mesh);
  r.origin.resize(r.mesh.triangles.size());
  std::iota(r.origin.begin(), r.origin.end(), 0u);
  r.toleranceMm = toleranceFor(r.mesh, options);
  r.maxHoleMm = options.maxHoleMm.value_or(kHoleFraction * boundingBox(r.mesh).diagonal());
  r.cleaning = cleanTriangles(r.mesh);
  follow(r.origin, r.cleaning.origin);
  EdgeTable edges = std::move(r.cleaning.edges);
  if (countEdges(edges, true) > 0) closeSeams(r, bodyOfTriangle, options, edges);
  r.adjacency = buildAdjacency(r.mesh.triangles, edges);
  r.consistency = makeConsistent(r.mesh.triangles, r.adjacency);
  if (options.fillHoles && countEdges(edges, true) > 0) QRELIEF_TRY(closeHoles(r, edges));
  r.defects = findDefects(r.mesh, edges, r.adjacency);
  if (r.defects.nonManifoldVertices > 0) {
    separateTouchingShells(r.mesh, edges);
    edges = buildEdgeTable(r.mesh.triangles);
    r.adjacency = buildAdjacency(r.mesh.triangles, edges);
    r.defects = findDefects(r.mesh, edges, r.adjacency);
  }
  r.outwardness = orientOutwards(r.mesh, r.adjacency, r.consistency, bodiesNow(r, bodyOfTriangle));
  dropUnused(r.mesh);
  if (r.closed()) {
    Result<Untangling> untangling = options.untangle ? untangle(r.mesh) : countCrossings(r.mesh);
    QRELIEF_TRY(untangling);
    r.untangling = *untangling;
    QRELIEF_TRY(listCrossings(r));
  }
  return r;
}

}  // namespace qrelief
