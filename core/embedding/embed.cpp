// SPDX-License-Identifier: GPL-3.0-or-later
#include "embedding/embed.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "embedding/clearance.h"
#include "embedding/lift.h"

namespace qrelief {
namespace {

/// Times that outlines are moved before the arrangement is given up.
constexpr int kAttempts = 8;

/// Lowest height of a new triangle, in units of the last place of the largest coordinate around. Rounding moves a
/// vertex by at most √3/2 of a unit, so a triangle this high keeps its orientation whichever way its corners go.
constexpr double kLowestHeightUlps = 4;

DepthLevels quantise(const DepthField& field) {
  DepthLevels levels{field.size, field.symbolMm, {}};
  levels.level.reserve(field.depthMm.size());
  for (const double depth : field.depthMm)
    levels.level.push_back(static_cast<int>(std::lround(depth / kDepthQuantumMm)));
  return levels;
}

/// Outlines so long that more than about two model vertices lie within reach of their snapping cannot keep clear of
/// all of them by moving their two ends alone.
int longestOutline(const Footprint& footprint, double submoduleMm, double snapMm) {
  double area = 0;
  for (const Triangle& t : footprint.corners) {
    const Vec2 a = footprint.points[t[0]];
    area += cross2(footprint.points[t[1]] - a, footprint.points[t[2]] - a) / 2;
  }
  const double perMm2 = static_cast<double>(footprint.points.size()) / area;
  return static_cast<int>(std::clamp(1 / (snapMm * perMm2 * submoduleMm), 1.0, 1e6));
}

EdgeGrid makeGrid(const Footprint& footprint) {
  std::vector<EdgeGrid::Edge> edges;
  edges.reserve(footprint.edges.size());
  for (const Footprint::Edge& e : footprint.edges) edges.push_back({footprint.points[e.a], footprint.points[e.b]});
  return EdgeGrid(std::move(edges));
}

double lowestHeight(const LiftedSurface& surface) {
  float largest = 0;
  for (const Vec3f& p : surface.positions) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return kLowestHeightUlps * (std::nextafter(largest, HUGE_VALF) - largest);
}

double height(const LiftedSurface& surface, const Triangle& t) {
  const Vec3 a(surface.positions[t[0]]), b(surface.positions[t[1]]), c(surface.positions[t[2]]);
  const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
  return longest > 0 ? glm::length(glm::cross(b - a, c - a)) / longest : 0;
}

/// Nodes on whose place the shape of too low triangles depends; ascending.
struct LowTriangles {
  std::size_t count = 0;
  std::vector<std::uint32_t> nodes;
};

LowTriangles findLowTriangles(const LiftedSurface& surface, const Arrangement& arrangement, const OutlineGraph& graph) {
  LowTriangles low;
  const double lowest = lowestHeight(surface);
  for (const Triangle& t : surface.triangles) {
    if (height(surface, t) >= lowest) continue;
    ++low.count;
    for (const std::uint32_t v : t) {
      const std::uint32_t point = surface.vertices[v].point;
      if (point >= arrangement.firstCrossing) {
        const Outline& o = graph.outlines[arrangement.crossings[point - arrangement.firstCrossing].outline];
        low.nodes.push_back(o.from);
        low.nodes.push_back(o.to);
      } else if (point >= arrangement.firstNode) {
        low.nodes.push_back(point - arrangement.firstNode);
      }
    }
  }
  std::sort(low.nodes.begin(), low.nodes.end());
  low.nodes.erase(std::unique(low.nodes.begin(), low.nodes.end()), low.nodes.end());
  return low;
}

std::vector<std::uint32_t> allNodes(const OutlineGraph& graph) {
  std::vector<std::uint32_t> nodes(graph.nodes.size());
  for (std::uint32_t k = 0; k < nodes.size(); ++k) nodes[k] = k;
  return nodes;
}

struct Carving {
  Arrangement arrangement;
  LiftedSurface surface;
};

/// Arranges and lifts; where the result is too fine for 32-bit floats, moves the outlines there and tries again.
Result<Carving> carve(const Mesh& mesh, const ProjectionFrame& frame, const Footprint& footprint, OutlineGraph graph,
                      double snapMm) {
  EdgeGrid edges = makeGrid(footprint);
  Clearance clearance(graph, edges, snapMm);
  clearance.placeAll();
  Error lastError;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    Result<Arrangement> arrangement = arrange(footprint, edges, graph);
    if (!arrangement) {
      if (arrangement.error().code != ErrorCode::Internal) return tl::unexpected(arrangement.error());
      lastError = arrangement.error();
      clearance.placeAgain(allNodes(graph));
      continue;
    }
    LiftedSurface surface = lift(mesh, frame, footprint, *arrangement);
    const LowTriangles low = findLowTriangles(surface, *arrangement, graph);
    if (low.count == 0) return Carving{std::move(*arrangement), std::move(surface)};
    lastError = {ErrorCode::Internal, fmt::format("{} carved triangles are too thin for 32-bit floats", low.count),
                 "choose a slightly different centre or size"};
    clearance.placeAgain(low.nodes);
  }
  return tl::unexpected(std::move(lastError));
}

/// Facets of the footprint that neither an outline cuts nor a pocket lowers.
std::vector<char> findUntouched(const Footprint& footprint, const Arrangement& arrangement) {
  std::vector<std::uint32_t> parts(footprint.facets.size(), 0);
  std::vector<char> untouched(footprint.facets.size(), 1);
  for (std::size_t t = 0; t < arrangement.triangles.size(); ++t) {
    const std::uint32_t facet = arrangement.facets[t];
    if (++parts[facet] > 1 || arrangement.levels[t] > 0) untouched[facet] = 0;
  }
  return untouched;
}

EmbedResult assemble(const Mesh& mesh, const Footprint& footprint, const Carving& carving) {
  const std::vector<char> untouched = findUntouched(footprint, carving.arrangement);
  std::vector<char> kept(mesh.triangles.size(), 1);
  for (std::size_t f = 0; f < footprint.facets.size(); ++f) kept[footprint.facets[f]] = untouched[f];

  EmbedResult result;
  const LiftedSurface& surface = carving.surface;
  constexpr std::uint32_t kUnused = 0xffffffffu, kUsed = 0;
  std::vector<std::uint32_t> place(mesh.positions.size(), kUnused), newPlace(surface.vertices.size(), kUnused);
  const auto isNew = [&](std::size_t t) { return t >= surface.firstWall || !untouched[carving.arrangement.facets[t]]; };
  const auto modelVertex = [&](std::uint32_t v) -> std::uint32_t* {
    const LiftedSurface::Vertex& vertex = surface.vertices[v];
    if (vertex.point >= carving.arrangement.firstNode || vertex.level > 0) return nullptr;
    return &place[footprint.vertices[vertex.point]];
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (kept[t])
      for (const std::uint32_t v : mesh.triangles[t]) place[v] = kUsed;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    if (isNew(t))
      for (const std::uint32_t v : surface.triangles[t]) *(modelVertex(v) ? modelVertex(v) : &newPlace[v]) = kUsed;

  const auto number = [&](std::vector<std::uint32_t>& places, const std::vector<Vec3f>& positions) {
    for (std::size_t v = 0; v < places.size(); ++v) {
      if (places[v] == kUnused) continue;
      places[v] = static_cast<std::uint32_t>(result.mesh.positions.size());
      result.mesh.positions.push_back(positions[v]);
    }
  };
  number(place, mesh.positions);
  number(newPlace, surface.positions);

  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    if (kept[t]) result.mesh.triangles.push_back({place[corners[0]], place[corners[1]], place[corners[2]]});
  }
  result.keptTriangles = result.mesh.triangles.size();
  const auto placeOf = [&](std::uint32_t v) { return modelVertex(v) ? *modelVertex(v) : newPlace[v]; };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (!isNew(t)) continue;
    const Triangle& corners = surface.triangles[t];
    result.newTriangles.push_back(static_cast<std::uint32_t>(result.mesh.triangles.size()));
    result.mesh.triangles.push_back({placeOf(corners[0]), placeOf(corners[1]), placeOf(corners[2])});
  }
  return result;
}

EmbedResult unchanged(const Mesh& mesh) { return {mesh, mesh.triangles.size(), {}}; }

}  // namespace

Result<EmbedResult> embedDepthField(const Mesh& mesh, const Adjacency& adjacency, const ProjectionFrame& frame,
                                    std::span<const std::uint32_t> patch, const DepthField& depths,
                                    const EmbedOptions& options) {
  const DepthLevels levels = quantise(depths);
  if (std::none_of(levels.level.begin(), levels.level.end(), [](int level) { return level > 0; }))
    return unchanged(mesh);
  const double snapMm = std::min(options.snapMm, levels.submoduleMm() / 20);
  const double chamferMm = std::min(options.chamferMm, levels.submoduleMm() / 4);

  const Result<Footprint> footprint = findFootprint(mesh, adjacency, frame, patch, levels, levels.submoduleMm() / 4);
  if (!footprint) return tl::unexpected(footprint.error());
  if (footprint->facets.empty())
    return fail(ErrorCode::NoSolution, "no part of the visible surface lies under the code",
                "choose another centre or direction");
  const int maxCells = longestOutline(*footprint, levels.submoduleMm(), snapMm);
  const Result<Carving> carving = carve(mesh, frame, *footprint, buildOutlines(levels, chamferMm, maxCells), snapMm);
  if (!carving) return tl::unexpected(carving.error());
  return assemble(mesh, *footprint, *carving);
}

}  // namespace qrelief
