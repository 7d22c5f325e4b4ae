// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/embed.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "carving/clearance.h"
#include "carving/inlay.h"
#include "carving/lift.h"
#include "carving/needle.h"
#include "math/float_step.h"
#include "mesh/collinear.h"
#include "message_codes/place.h"

namespace qrelief {
namespace {

/// Number of attempts to move outlines before the arrangement fails.
constexpr int kAttempts = 8;
/// Number of arrangements that may be refused as a whole; moving outlines hardly ever helps then.
constexpr int kRefusals = 2;

DepthLevels quantise(const DepthField& field) {
  assert(field.depthMm.size() == static_cast<std::size_t>(field.size) * static_cast<std::size_t>(field.size));
  DepthLevels levels{field.size, field.symbolMm, {}};
  levels.level.reserve(field.depthMm.size());
  for (const double depth : field.depthMm)
    levels.level.push_back(static_cast<int>(std::lround(depth / kDepthQuantumMm)));
  return levels;
}

/// Returns the greatest length of an outline, in submodules. A longer outline has more than about two model vertices
/// within reach of its snapping, and moving its two ends cannot keep it clear of them all.
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

struct Carving {
  Arrangement arrangement;
  std::vector<char> untouched;  // by facet of the footprint
  LiftedSurface surface;        // flat, without walls, if the outlines only cut it

  bool isNew(std::size_t triangle) const {
    if (triangle >= surface.firstWall || arrangement.facets[triangle] == Arrangement::kGridFacet) return true;
    return !untouched[arrangement.facets[triangle]];
  }
};

/// New triangles that are too low for 32-bit floats, and the nodes that determine their shape. Triangles of the surface
/// over the pockets, which an inlay keeps, count if they are cut.
struct LowTriangles {
  std::size_t count = 0, collinear = 0;
  std::vector<std::uint32_t> nodes;  // ascending
};

LowTriangles findLowTriangles(const Carving& carving, const OutlineGraph& graph) {
  LowTriangles low;
  const LiftedSurface& surface = carving.surface;
  const Arrangement& arrangement = carving.arrangement;
  const double lowest = lowestHeight(surface.positions);
  const auto addNode = [&](std::uint32_t node) {
    if (graph.leewayMm[node] > 0) low.nodes.push_back(node);
  };
  const auto examine = [&](const Triangle& corners) {
    const Vec3f a = surface.positions[corners[0]], b = surface.positions[corners[1]], c = surface.positions[corners[2]];
    if (triangleHeight(a, b, c) >= lowest) return;
    ++low.count;
    if (collinear(a, b, c)) ++low.collinear;
    for (const std::uint32_t v : corners) {
      const std::uint32_t point = surface.vertices[v].point;
      if (point >= arrangement.firstCrossing) {
        const Outline& o = graph.outlines[arrangement.crossings[point - arrangement.firstCrossing].outline];
        addNode(o.from);
        addNode(o.to);
      } else if (point >= arrangement.firstNode) {
        addNode(point - arrangement.firstNode);
      }
    }
  };
  const auto isCut = [&](std::uint32_t point) { return point >= arrangement.firstNode; };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (carving.isNew(t)) examine(surface.triangles[t]);
    if (t >= surface.firstWall || arrangement.levels[t] == 0) continue;
    const Triangle& points = arrangement.triangles[t];
    if (!std::any_of(points.begin(), points.end(), isCut)) continue;
    examine({surface.surfaceVertex[points[0]], surface.surfaceVertex[points[1]], surface.surfaceVertex[points[2]]});
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

/// Finds the facets of the footprint that no outline cuts, no pocket lowers and no grid replaces. The arrangement holds
/// them whole, as triangles between model vertices.
std::vector<char> findUntouched(const Footprint& footprint, const Arrangement& arrangement) {
  std::vector<char> untouched(footprint.facets.size(), 0);
  for (std::size_t t = 0; t < arrangement.triangles.size(); ++t) {
    const std::uint32_t facet = arrangement.facets[t];
    const auto ofModel = [&](std::uint32_t point) { return point < arrangement.firstNode; };
    if (facet == Arrangement::kGridFacet || arrangement.levels[t] > 0 || footprint.reshaped[facet]) continue;
    const Triangle& corners = arrangement.triangles[t];
    if (std::all_of(corners.begin(), corners.end(), ofModel)) untouched[facet] = 1;
  }
  return untouched;
}

/// Returns the arrangement of the same triangles, nowhere lowered.
Arrangement flat(Arrangement arrangement) {
  std::fill(arrangement.levels.begin(), arrangement.levels.end(), 0);
  arrangement.pieces.clear();
  return arrangement;
}

/// Arranges and lifts. Where the result is too fine for 32-bit floats, moves the outlines and tries again.
Result<Carving> carve(const Mesh& mesh, const ProjectionFrame& frame, const Footprint& footprint, OutlineGraph graph,
                      double snapMm, bool paint) {
  EdgeGrid edges = makeGrid(footprint);
  Clearance clearance(graph, edges, snapMm);
  clearance.placeAll();
  int refusals = 0;
  for (int attempt = 1;; ++attempt) {
    Result<Arrangement> arrangement = arrange(footprint, edges, graph);
    if (!arrangement) {
      if (arrangement.error().kind != ErrorKind::Internal || ++refusals == kRefusals)
        return tl::unexpected(arrangement.error());
      clearance.placeAgain(allNodes(graph));
      continue;
    }
    Carving carving{std::move(*arrangement), {}, {}};
    carving.untouched = findUntouched(footprint, carving.arrangement);
    carving.surface = lift(mesh, frame, footprint, paint ? flat(carving.arrangement) : carving.arrangement);
    const LowTriangles low = findLowTriangles(carving, graph);
    if (low.count == 0) return carving;
    if (attempt == kAttempts || low.nodes.empty()) {
      // Low triangles are only a risk, which the final check judges. Collinear ones always do harm.
      if (low.collinear == 0) return carving;
      return fail(ErrorKind::NoSolution,
                  whyTooFine(frame.centre, message<"facets-too-fine">(with::count<"count">(low.collinear))));
    }
    clearance.placeAgain(low.nodes);
  }
}

/// Returns the origin of a new triangle of the surface.
FacetOrigin originOf(const Footprint& footprint, const Carving& carving, std::size_t triangle, double symbolMm,
                     bool paint) {
  using Kind = FacetOrigin::Kind;
  const Arrangement& arrangement = carving.arrangement;
  const auto isOutside = [&](std::uint32_t vertex) {
    const Vec2 p = arrangement.points[carving.surface.vertices[vertex].point];
    return std::max(std::abs(p.x), std::abs(p.y)) > symbolMm / 2;
  };
  const Triangle& corners = carving.surface.triangles[triangle];
  FacetOrigin origin;
  if (triangle >= carving.surface.firstWall) {
    origin.kind = Kind::Wall;
  } else {
    origin.kind = !paint && arrangement.levels[triangle] > 0 ? Kind::Floor : Kind::Piece;
    if (const std::uint32_t f = arrangement.facets[triangle]; f != Arrangement::kGridFacet)
      origin.facet = footprint.facets[f];
  }
  origin.isOfLabel = origin.kind != Kind::Piece && std::any_of(corners.begin(), corners.end(), isOutside);
  return origin;
}

EmbedResult assemble(const Mesh& mesh, const Footprint& footprint, const Carving& carving, double symbolMm,
                     bool paint) {
  const std::vector<char>& untouched = carving.untouched;
  std::vector<char> isKept(mesh.triangles.size(), 1);
  for (std::size_t f = 0; f < footprint.facets.size(); ++f) isKept[footprint.facets[f]] = untouched[f];

  EmbedResult result;
  const LiftedSurface& surface = carving.surface;
  constexpr std::uint32_t kUnused = 0xffffffffu, kUsed = 0;
  std::vector<std::uint32_t> place(mesh.positions.size(), kUnused), newPlace(surface.vertices.size(), kUnused);
  const auto modelVertex = [&](std::uint32_t v) -> std::uint32_t* {
    const LiftedSurface::Vertex& vertex = surface.vertices[v];
    if (vertex.point >= carving.arrangement.firstNode || vertex.level > 0) return nullptr;
    return &place[footprint.vertices[vertex.point]];
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (isKept[t])
      for (const std::uint32_t v : mesh.triangles[t]) place[v] = kUsed;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    if (carving.isNew(t))
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
    if (!isKept[t]) continue;
    result.mesh.triangles.push_back({place[corners[0]], place[corners[1]], place[corners[2]]});
    result.origins.push_back({FacetOrigin::Kind::Kept, false, static_cast<std::uint32_t>(t)});
    if (!mesh.bodyOf.empty()) result.mesh.bodyOf.push_back(mesh.bodyOf[t]);
  }
  result.keptTriangles = result.mesh.triangles.size();
  const auto placeOf = [&](std::uint32_t v) { return modelVertex(v) ? *modelVertex(v) : newPlace[v]; };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (!carving.isNew(t)) continue;
    const Triangle& corners = surface.triangles[t];
    if (paint && carving.arrangement.levels[t] > 0)
      result.painted.push_back(static_cast<std::uint32_t>(result.mesh.triangles.size()));
    result.newTriangles.push_back(static_cast<std::uint32_t>(result.mesh.triangles.size()));
    result.mesh.triangles.push_back({placeOf(corners[0]), placeOf(corners[1]), placeOf(corners[2])});
    result.origins.push_back(originOf(footprint, carving, t, symbolMm, paint));
    // The patch is connected by edges, so all its facets are of one body.
    if (!mesh.bodyOf.empty()) result.mesh.bodyOf.push_back(mesh.bodyOf[footprint.facets.front()]);
  }
  return result;
}

EmbedResult unchanged(const Mesh& mesh) {
  EmbedResult result;
  result.mesh = mesh;
  result.keptTriangles = mesh.triangles.size();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    result.origins.push_back({FacetOrigin::Kind::Kept, false, t});
  return result;
}

/// Returns the submodules whose facets are affected: with a resampled surface all, even uncarved ones.
DepthLevels concerned(DepthLevels levels, SurfaceMode surface) {
  if (surface == SurfaceMode::Resampled) std::fill(levels.level.begin(), levels.level.end(), 1);
  return levels;
}

}  // namespace

Message whyTooFine(Vec3 at, Message facets) {
  const double farthestMm = std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)});
  const double stepMm = floatStepMm(farthestMm);
  if (stepMm <= kCoarseStepMm) return facets;
  return message<"coordinates-too-coarse">(with::lengthMm<"distance">(farthestMm), with::lengthMm<"step">(stepMm));
}

Result<EmbedResult> embedDepthField(const Mesh& mesh, const ProjectionFrame& frame,
                                    std::span<const std::uint32_t> patch, const DepthField& depths,
                                    const EmbedOptions& options) {
  assert(!options.paint || options.surface == SurfaceMode::Preserved);
  const DepthLevels levels = quantise(depths);
  const bool isLabelAlone = std::none_of(levels.level.begin(), levels.level.end(), [](int level) { return level > 0; });
  if (isLabelAlone && options.label.empty()) return unchanged(mesh);
  const double snapMm = std::min(options.snapMm, levels.submoduleMm() / 20);
  const double chamferMm = std::min(options.chamferMm, levels.submoduleMm() / 4);

  const Result<Footprint> footprint =
      findFootprint(mesh, frame, patch, concerned(levels, options.surface), levels.submoduleMm() / 4, options.label);
  QRELIEF_TRY(footprint);
  if (footprint->facets.empty()) return fail(ErrorKind::NoSolution, message<"nothing-under-code">());
  const int longest = longestOutline(*footprint, levels.submoduleMm(), snapMm);
  OutlineGraph graph = options.surface == SurfaceMode::Resampled ? buildGridOutlines(levels, chamferMm)
                                                                 : buildOutlines(levels, chamferMm, longest);
  addOutlines(graph, options.label, longest * levels.submoduleMm());
  const Result<Carving> carving = carve(mesh, frame, *footprint, std::move(graph), snapMm, options.paint);
  QRELIEF_TRY(carving);
  EmbedResult result = assemble(mesh, *footprint, *carving, isLabelAlone ? 0 : levels.symbolMm, options.paint);
  if (options.inlay) result.inlay = inlayMesh(carving->arrangement, carving->surface);
  return result;
}

}  // namespace qrelief
