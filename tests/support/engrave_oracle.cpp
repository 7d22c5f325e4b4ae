// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/engrave_oracle.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <set>

#include "carving/carving_oracle.h"
#include "depth/wall_limit.h"
#include "io/write_stl.h"
#include "math/angle.h"
#include "math/tolerance.h"
#include "mesh/ray.h"
#include "message_codes/pipeline.h"
#include "messages/sentences.h"
#include "projection/occlusion.h"
#include "support/brute_force.h"
#include "support/plane_caster.h"
#include "support/shapes.h"
#include "support/solid_oracle.h"

namespace qrelief {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDeepestMm = 2;  // limit of the made-up depths

double outerFactor(const PlacementRequest& place, int modules) {
  return place.quietZone ? (modules + 2.0 * kQuietZoneModules) / modules : 1.0;
}

bool warnedOf(const PreparedModel& prepared, std::string_view code) {
  return std::any_of(prepared.findings.begin(), prepared.findings.end(),
                     [&](const Finding& finding) { return finding.message.code == code; });
}

/// Returns plane point k of an even sequence inside a submodule, at least a quarter of the submodule away from its rim,
/// where outlines may lie.
Vec2 pointOf(const DepthField& field, int row, int column, int k) {
  const Vec2 place(std::fmod(0.47 + 0.7548776662466927 * k, 1.0), std::fmod(0.58 + 0.5698402909980532 * k, 1.0));
  const Vec2 inside = (place * 0.46 + 0.27) * field.submoduleMm();
  return field.corner(row, column) + Vec2(inside.x, -inside.y);
}

// ---- Extent of the surface visible in one piece ----

/// Largest code about a centre that no ray contradicts.
struct Reach {
  double freeMm = std::numeric_limits<double>::infinity();      ///< at any rotation
  double orientedMm = std::numeric_limits<double>::infinity();  ///< at the frame's rotation
  std::vector<std::uint32_t> facets;                            ///< facets that rays met on the way, ascending
};

/// Walks outwards from the centre in `ways` directions by `steps` steps until a ray misses the model or steps to
/// another part of it. Misses gaps narrower than the steps, so its result is an upper bound.
Reach walkOutwards(const Mesh& mesh, const ProjectionFrame& frame, double squareMm, int ways, int steps) {
  const double reach = squareMm / 2;
  const PlaneCaster caster(mesh, frame, 1.01 * reach);
  Reach found;
  const auto stopAt = [&](Vec2 p) {
    found.freeMm = std::min(found.freeMm, std::numbers::sqrt2 * glm::length(p));
    found.orientedMm = std::min(found.orientedMm, 2 * std::max(std::abs(p.x), std::abs(p.y)));
  };
  const auto centre = caster.hit(Vec2(0));
  if (!centre || !centre->front || centre->distance < frame.eyeDistance - kOnSurfaceMm) {
    stopAt(Vec2(0));
    return found;
  }
  std::set<std::uint32_t> met{centre->triangle};
  for (int way = 0; way < ways; ++way) {
    // The directions lead to points of the square's rim, slightly rotated so that none runs along the model's own axes.
    const double angle = 2 * kPi * (way + 0.377) / ways;
    const Vec2 unit(std::cos(angle), std::sin(angle));
    const Vec2 rim = unit * (reach / std::max(std::abs(unit.x), std::abs(unit.y)));
    Vec2 last(0);
    PlaneCaster::Hit lastHit = *centre;
    for (int step = 1; step <= steps; ++step) {
      const Vec2 next = rim * (static_cast<double>(step) / steps);
      const auto hit = caster.hit(next);
      if (!hit || !hit->front || !caster.connected(last, lastHit, next, *hit)) {
        stopAt(next);
        break;
      }
      last = next;
      lastHit = *hit;
      met.insert(hit->triangle);
    }
  }
  found.facets.assign(met.begin(), met.end());
  return found;
}

// ---- Solids ----

std::string solidFault(const EngravableModel& model, const EngraveResult& result, const Mesh& carved) {
  const std::string problem = surfaceProblems(carved);
  if (!problem.empty()) return problem;
  const std::vector<std::uint32_t> newFacets = facetsNotIn(carved, model.prepared.mesh);
  if (newFacets.empty()) return "nothing was carved";
  if (carved.triangles.size() - newFacets.size() != result.keptTriangles)
    return fmt::format("{} facets are said to be kept, {} are", result.keptTriangles,
                       carved.triangles.size() - newFacets.size());
  if (warnedOf(model.prepared, "self-intersections")) return {};  // inherited crossings look like new ones
  if (const std::size_t crossings = countCrossings(carved, newFacets); crossings > 0)
    return fmt::format("{} pairs of triangles cross", crossings);
  if (!result.solidity.solid())
    return "the job says that it is no solid: " + sentence(result.solidity.problems().front());
  return {};
}

/// Checks that facets that face away, or whose images stay clear of the code, still exist.
std::string untouchedFault(const EngravableModel& model, const EngraveResult& result, const Mesh& carved) {
  const Mesh& before = model.prepared.mesh;
  const ProjectionFrame& frame = result.placement.frame;
  const double half = result.placement.symbolMm / 2 + result.depths.submoduleMm();
  for (const std::uint32_t t : facetsNotIn(before, carved)) {
    const Vec3 a = before.corner(t, 0);
    const Vec3 normal = glm::cross(before.corner(t, 1) - a, before.corner(t, 2) - a);
    if (glm::dot(normal, frame.eye() - a) < 0) return fmt::format("facet {} faces away and is gone", t);
    Vec2 lo(std::numeric_limits<double>::infinity()), hi = -lo;
    for (int k = 0; k < 3; ++k) {
      lo = glm::min(lo, frame.project(before.corner(t, k)));
      hi = glm::max(hi, frame.project(before.corner(t, k)));
    }
    if (lo.x > half || lo.y > half || hi.x < -half || hi.y < -half)
      return fmt::format("facet {} lies beside the code and is gone", t);
  }
  return {};
}

std::string depthFault(const PlaneCaster& before, const PlaneCaster& after, const EngraveResult& result) {
  const DepthField& field = result.depths;
  constexpr int kSamples = 1500;
  // Outlines shift by this much towards the model's corners; a floor that ends on a crease follows it that far.
  const double tolerance = EmbedOptions().snapMm;
  Random random(static_cast<std::uint64_t>(field.size));
  for (int k = 0; k < kSamples; ++k) {
    const auto row = static_cast<int>(random.below(static_cast<std::uint64_t>(field.size)));
    const auto column = static_cast<int>(random.below(static_cast<std::uint64_t>(field.size)));
    const Vec2 p = pointOf(field, row, column, k);
    const double deeper = after.distance(p) - before.distance(p);
    if (!(std::abs(deeper - field.depth(row, column)) < tolerance))
      return fmt::format("submodule ({}, {}) is {:.6g} mm deep, not {:.6g}", row, column, deeper,
                         field.depth(row, column));
  }
  return {};
}

std::string volumeFault(const PlaneCaster& before, const EngravableModel& model, const EngraveResult& result,
                        const Mesh& carved) {
  const double lost = signedVolume(model.prepared.mesh) - signedVolume(carved);
  const double pockets =
      oracle::pocketVolume(result.placement.frame, result.depths, [&](Vec2 p) { return before.distance(p); });
  // Outlines lie slightly off the grid's lines, up to an eighth of a submodule where the model is dense.
  const double share = std::min(0.02, result.depths.submoduleMm() / 20) * oracle::wallArea(result.depths);
  if (!(lost > 0)) return fmt::format("the volume grew by {:.4g} mm3", -lost);
  if (std::abs(lost - pockets) > share + 0.03 * pockets)
    return fmt::format("{:.5g} mm3 are gone, but the pockets have {:.5g}", lost, pockets);
  return {};
}

/// Returns the facets that a floor must keep away from: facets that face away, and facets near the code that face the
/// eye but do not belong to the visible patch.
std::vector<std::uint32_t> wallFacets(const Mesh& mesh, const Placement& placement) {
  const ProjectionFrame& frame = placement.frame;
  std::vector<std::uint32_t> walls;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (std::binary_search(placement.patch.triangles.begin(), placement.patch.triangles.end(), t)) continue;
    const Vec3 a = mesh.corner(t, 0);
    const bool front = glm::dot(glm::cross(mesh.corner(t, 1) - a, mesh.corner(t, 2) - a), frame.eye() - a) > 0;
    const Vec3 middle = (a + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
    const bool isNear =
        frame.distanceAlongAxis(middle) > 0 && glm::length(frame.project(middle)) < placement.symbolMm / 2;
    if (!front || isNear) walls.push_back(t);
  }
  return walls;
}

double distanceTo(const Mesh& mesh, const std::vector<std::uint32_t>& facets, Vec3 p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::uint32_t t : facets)
    nearest =
        std::min(nearest, brute_force::distanceToFacet(p, mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)));
  return nearest;
}

std::string wallFault(const PlaneCaster& after, const EngraveCase& engraveCase, const EngravableModel& model,
                      const EngraveResult& result) {
  const Mesh& mesh = model.prepared.mesh;
  const DepthField& field = result.depths;
  const ProjectionFrame& frame = result.placement.frame;
  const std::vector<std::uint32_t> walls = wallFacets(mesh, result.placement);
  constexpr int kSamples = 300;
  Random random(static_cast<std::uint64_t>(field.size) + 1);
  for (int k = 0; k < kSamples; ++k) {
    const auto row = static_cast<int>(random.below(static_cast<std::uint64_t>(field.size)));
    const auto column = static_cast<int>(random.below(static_cast<std::uint64_t>(field.size)));
    if (field.depth(row, column) == 0) continue;
    const Vec2 p = pointOf(field, row, column, k);
    const Vec3 floor = frame.eye() + frame.rayDirection(p) * after.distance(p);
    const double wall = distanceTo(mesh, walls, floor);
    if (wall < engraveCase.request.depth.minWallMm - kDepthQuantumMm - 0.05 * field.submoduleMm())
      return fmt::format("behind submodule ({}, {}) {:.4g} mm of wall are left, not {:.4g}", row, column, wall,
                         engraveCase.request.depth.minWallMm);
  }
  return {};
}

std::string seenFault(const EngraveCase& engraveCase, const EngravableModel& model, const EngraveResult& result) {
  const double square = result.placement.symbolMm * outerFactor(engraveCase.request.placement, result.symbol.size);
  const Reach reach = walkOutwards(model.prepared.mesh, result.placement.frame, square * (1 - 1e-9), 96, 24);
  if (std::isinf(reach.orientedMm)) return {};
  return fmt::format("the code of {:.5g} mm is broken by the silhouette {:.5g} mm out", square, reach.orientedMm / 2);
}

OracleVerdict judgeSolid(const EngraveCase& engraveCase, const EngravableModel& model, const EngraveResult& result) {
  const Mesh carved = meshOfStl(writeStl(result.mesh));
  const double half = result.placement.symbolMm / 2;
  const PlaneCaster before(model.prepared.mesh, result.placement.frame, half);
  const PlaneCaster after(carved, result.placement.frame, half);
  std::string fault = solidFault(model, result, carved);
  if (fault.empty()) fault = untouchedFault(model, result, carved);
  if (fault.empty()) fault = seenFault(engraveCase, model, result);
  // A resampled surface differs from the model's, so depths cannot be measured from the model.
  const bool isPreserved = engraveCase.request.depth.surface == SurfaceMode::Preserved;
  if (fault.empty() && isPreserved) fault = depthFault(before, after, result);
  if (fault.empty() && isPreserved) fault = volumeFault(before, model, result, carved);
  if (fault.empty()) fault = wallFault(after, engraveCase, model, result);
  return {"solid", fault};
}

// ---- Refusals ----

/// Result of the placement search alone: its placement, and every direction it looked from.
struct Search {
  Placement placement;
  std::vector<ProjectionFrame> frames;
};

ProjectionFrame frameOf(const PlacementRequest& place, Vec3 centre, Vec3 normal) {
  ProjectionFrame frame = makeFrame(centre, normal, place.upHint, place.eyeDistanceMm);
  const double angle = toRadians(place.rotateDeg);
  const Vec3 right = frame.right * std::cos(angle) + frame.up * std::sin(angle);
  frame.up = frame.up * std::cos(angle) - frame.right * std::sin(angle);
  frame.right = right;
  return frame;
}

Search repeatSearch(const EngraveCase& engraveCase, const EngravableModel& model, int modules) {
  const PlacementRequest& place = engraveCase.request.placement;
  Search repeated;
  PlacementSearch search(model.prepared, *model.renderer, modules, place);
  for (;;) {
    const Result<bool> step = search.step();
    if (!step || *step) break;
  }
  repeated.placement = search.placement();
  const Vec3 centre = search.placement().frame.centre;
  const auto nearest = closestPoint(model.prepared.mesh, place.centreMm);
  repeated.frames.push_back(
      frameOf(place, centre, place.direction.value_or(surfaceNormalAt(model.prepared.mesh, *nearest))));
  for (const DirectionIteration& iteration : search.placement().iterations)
    repeated.frames.push_back(frameOf(place, centre, iteration.normal));
  return repeated;
}

/// Checks that from every direction the search looked from, the silhouette breaks a code of `symbolMm`.
std::string fitFault(const EngraveCase& engraveCase, const EngravableModel& model, const Search& search, int modules,
                     double symbolMm) {
  const double square = symbolMm * roomFactor(modules, engraveCase.request.placement);
  const bool anyRotation = engraveCase.request.placement.sizeMode == SizeMode::Free;
  for (const ProjectionFrame& frame : search.frames) {
    // Over all rotations the square's corners sweep a disc; a larger square encloses it.
    const double looked = square * (anyRotation ? std::numbers::sqrt2 : 1.0);
    const Reach reach = walkOutwards(model.prepared.mesh, frame, looked, 720, 200);
    const double largest = anyRotation ? reach.freeMm : reach.orientedMm;
    if (largest > square * 1.01)
      return fmt::format("a code of {:.4g} mm is said not to fit, but no ray contradicts it", symbolMm);
  }
  return {};
}

std::string thinFault(const EngraveCase& engraveCase, const EngravableModel& model, const Search& search,
                      const Symbol& symbol) {
  const Placement& placement = search.placement;
  const SubmoduleMask mask =
      submodulesToCarve(symbol, *engraveCase.request.code.modulePattern, *engraveCase.request.code.finderPattern);
  const DepthField field{mask.rows(), placement.symbolMm, {}};
  const PlaneCaster before(model.prepared.mesh, placement.frame, placement.symbolMm / 2);
  const std::vector<std::uint32_t> walls = wallFacets(model.prepared.mesh, placement);
  Random random(2);
  for (int k = 0; k < 300; ++k) {
    const auto row = static_cast<int>(random.below(static_cast<std::uint64_t>(field.size)));
    const auto column = static_cast<int>(random.below(static_cast<std::uint64_t>(field.size)));
    if (!mask.at(row, column)) continue;
    const Vec2 p = field.corner(row, column) + Vec2(0.5, -0.5) * field.submoduleMm();
    const Vec3 top = placement.frame.eye() + placement.frame.rayDirection(p) * before.distance(p);
    const double spare = distanceTo(model.prepared.mesh, walls, top) - engraveCase.request.depth.minWallMm;
    if (spare > 0.05 + field.submoduleMm())
      return fmt::format("submodule ({}, {}) has {:.4g} mm to spare", row, column, spare);
  }
  return {};
}

/// Returns the facets that hold the centre: several if it lies on an edge or vertex.
std::vector<std::uint32_t> facetsAt(const Mesh& mesh, Vec3 centre) {
  std::vector<std::uint32_t> facets;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (brute_force::distanceToFacet(centre, mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)) < 1e-9)
      facets.push_back(t);
  return facets;
}

/// Returns true if any facet at the centre faces away: then the silhouette runs through the centre.
bool facesAway(const Mesh& mesh, const ProjectionFrame& frame) {
  const std::vector<std::uint32_t> facets = facetsAt(mesh, frame.centre);
  return std::any_of(facets.begin(), facets.end(), [&](std::uint32_t t) {
    return glm::dot(triangleNormal(mesh, t), glm::normalize(frame.eye() - mesh.corner(t, 0))) < 1e-6;
  });
}

bool isHidden(const Mesh& mesh, const ProjectionFrame& frame) {
  return brute_force::castRay(mesh, frame.eye(), -frame.normal).distance < frame.eyeDistance - kOnSurfaceMm;
}

bool reachesBehindEye(const Mesh& mesh, const ProjectionFrame& frame) {
  const std::vector<std::uint32_t> facets = facetsAt(mesh, frame.centre);
  return std::any_of(facets.begin(), facets.end(), [&](std::uint32_t t) {
    for (int k = 0; k < 3; ++k)
      if (frame.distanceAlongAxis(mesh.corner(t, k)) <= 1e-6 * frame.eyeDistance) return true;
    return false;
  });
}

/// Checks that the reason is true of at least one direction that the search looked from.
std::string reasonFault(const EngravableModel& model, const Search& search, const char* reason,
                        bool (*isTrue)(const Mesh&, const ProjectionFrame&)) {
  const bool any = std::any_of(search.frames.begin(), search.frames.end(),
                               [&](const ProjectionFrame& frame) { return isTrue(model.prepared.mesh, frame); });
  return any ? "" : fmt::format("from no direction that was looked from {}", reason);
}

bool isFarAway(const Mesh&, const ProjectionFrame& frame) {
  const Vec3 far = glm::abs(frame.centre);
  return std::max({far.x, far.y, far.z}) * std::numeric_limits<float>::epsilon() > 0.0009;
}

/// Checks that the code's area has facets only a few dozen float steps wide.
std::string fineFault(const EngravableModel& model, const Search& search) {
  const Mesh& mesh = model.prepared.mesh;
  const Box3 box = boundingBox(mesh);
  const Vec3 far = glm::max(glm::abs(box.min), glm::abs(box.max));
  const double step = std::max({far.x, far.y, far.z}) * std::numeric_limits<float>::epsilon();
  for (const std::uint32_t t : search.placement.patch.triangles) {
    const Vec3 a = mesh.corner(t, 0), u = mesh.corner(t, 1) - a, v = mesh.corner(t, 2) - a;
    const double longest = std::max({glm::length(u), glm::length(v), glm::length(v - u)});
    if (glm::length(glm::cross(u, v)) / longest < 100 * step) return {};
  }
  return "no facet there is finer than 100 steps of a float";
}

/// Compares the diagonal of the smallest code with the model's, seen from the eye as large as its nearest point may
/// appear.
std::string smallFault(const EngraveCase& engraveCase, const EngravableModel& model, int modules) {
  const double diagonal = boundingBox(model.prepared.mesh).diagonal();
  const PlacementRequest& place = engraveCase.request.placement;
  const double least = 0.2 * modules * outerFactor(place, modules);
  const double enlarged = diagonal * place.eyeDistanceMm / (place.eyeDistanceMm - diagonal);
  return std::sqrt(2) * least > enlarged ? "" : "the model may have room for a code";
}

OracleVerdict judgeNoSolution(const EngraveCase& engraveCase, const EngravableModel& model, const Error& error) {
  const auto says = [&](auto... codes) { return ((error.message.code == codes) || ...); };
  const auto symbol = encodeSymbol(engraveCase.request.code.text, engraveCase.request.code.symbol);
  if (!symbol) return {"no solution", "the text cannot be encoded, and nothing said so: " + sentence(error.message)};
  if (error.message.code == "model-too-small") return {"model too small", smallFault(engraveCase, model, symbol->size)};
  const Search search = repeatSearch(engraveCase, model, symbol->size);
  if (says("code-too-large", "code-too-large-here", "code-fits-turned"))
    return {"does not fit", fitFault(engraveCase, model, search, symbol->size, engraveCase.request.placement.sizeMm)};
  if (says("modules-too-small-as-asked")) {
    const PlacementRequest& place = engraveCase.request.placement;
    const double asked = place.sizeMode == SizeMode::Fixed ? place.sizeMm : place.maxSizeMm;
    return {"asks for a tiny code", asked < 0.2 * symbol->size ? "" : "the modules would be wide enough"};
  }
  if (says("modules-too-small-here"))  // the modules would be narrower than 0.2 mm
    return {"fits a tiny code only", fitFault(engraveCase, model, search, symbol->size, 0.2 * symbol->size)};
  if (says("centre-faces-away")) return {"faces away", reasonFault(model, search, "the centre faces away", facesAway)};
  if (says("centre-hidden")) return {"hidden", reasonFault(model, search, "anything is before the centre", isHidden)};
  if (says("centre-behind-eye"))
    return {"behind the eye", reasonFault(model, search, "the facet reaches behind the eye", reachesBehindEye)};
  if (says("nothing-can-be-carved", "nothing-can-be-carved-over-shell"))
    return {"wall too thin", thinFault(engraveCase, model, search, *symbol)};
  if (says("coordinates-too-coarse"))
    return {"far away", reasonFault(model, search, "coordinates are coarse", isFarAway)};
  if (says("facets-too-fine", "carved-not-solid")) return {"facets too fine", fineFault(model, search)};
  return {"no solution", "a reason that nobody checks: " + sentence(error.message)};
}

/// Capacity, bytes, of a symbol of version 1 to 5 in byte mode [ISO/IEC 18004, table 7].
constexpr std::array<std::array<std::size_t, 4>, 5> kByteCapacity = {
    {{17, 14, 11, 7}, {32, 26, 20, 14}, {53, 42, 32, 24}, {78, 62, 46, 34}, {106, 84, 60, 44}}};

OracleVerdict judgeBadInput(const EngraveCase& engraveCase, const EngravableModel& model, const Error& error) {
  if (!model.prepared.engravable()) {
    const bool torn = !surfaceProblems(engraveCase.mesh).empty();
    return {"no solid", torn ? "" : "the model is a solid, but: " + sentence(error.message)};
  }
  const std::optional<int> version = engraveCase.request.code.symbol.version;
  const auto level = static_cast<std::size_t>(engraveCase.request.code.symbol.errorCorrection);
  if (!version) return {"bad input", "a reason that nobody checks: " + sentence(error.message)};
  const bool tooLong =
      engraveCase.request.code.text.size() > kByteCapacity[static_cast<std::size_t>(*version - 1)][level];
  return {"text too long", tooLong ? "" : "the text fits: " + sentence(error.message)};
}

/// Makes up uneven depths for the submodules of a mask: one level per module, one per submodule, or the same
/// everywhere.
std::vector<double> madeUpDepths(const SubmoduleMask& mask, std::span<const double> limits, Choices& choices) {
  const int grain = choices.of(std::array{kSubmodulesPerModule, 1, mask.rows()});
  const int perEdge = (mask.rows() + grain - 1) / grain;
  const int levels = choices.between(1, static_cast<int>(kDeepestMm / kDepthQuantumMm));
  std::vector<double> wanted;
  Random random(choices.below(65536));
  for (int k = 0; k < perEdge * perEdge; ++k)
    wanted.push_back(kDepthQuantumMm * static_cast<double>(1 + random.below(static_cast<std::uint64_t>(levels))));
  std::vector<double> depths(limits.size(), 0);
  for (int row = 0; row < mask.rows(); ++row)
    for (int column = 0; column < mask.rows(); ++column) {
      const auto i = static_cast<std::size_t>(row * mask.rows() + column);
      const double depth =
          std::min(limits[i], wanted[static_cast<std::size_t>(row / grain * perEdge + column / grain)]);
      if (mask.at(row, column)) depths[i] = kDepthQuantumMm * std::floor(depth / kDepthQuantumMm + 1e-6);
    }
  return depths;
}

/// Makes depths, embedding and the file for a placement.
Result<EngraveResult> carve(const EngraveCase& engraveCase, const EngravableModel& model, Placement placement,
                            const Symbol& symbol, Choices& choices) {
  const Mesh& mesh = model.prepared.mesh;
  EngraveResult result;
  const SubmoduleMask mask =
      submodulesToCarve(symbol, *engraveCase.request.code.modulePattern, *engraveCase.request.code.finderPattern);
  result.depths = {mask.rows(), placement.symbolMm, {}};
  const std::vector<double> limits = wallLimits(mesh, placement.patch, placement.frame, mask,
                                                {placement.symbolMm, kDeepestMm, engraveCase.request.depth.minWallMm});
  result.depths.depthMm = madeUpDepths(mask, limits, choices);
  if (std::none_of(result.depths.depthMm.begin(), result.depths.depthMm.end(), [](double depth) { return depth > 0; }))
    return fail(ErrorKind::NoSolution,
                message<"nothing-can-be-carved">(with::lengthMm<"wall">(engraveCase.request.depth.minWallMm)));
  const auto embedded = embedDepthField(mesh, placement.frame, placement.patch.triangles, result.depths,
                                        {.surface = engraveCase.request.depth.surface});
  if (!embedded) return tl::unexpected(embedded.error());
  result.keptTriangles = embedded->keptTriangles;
  result.mesh = oracle::welded(embedded->mesh);
  const auto solidity = checkSolidity(result.mesh, embedded->newTriangles);
  if (!solidity) return tl::unexpected(solidity.error());
  result.solidity = *solidity;
  result.symbol = symbol;
  result.placement = std::move(placement);
  return result;
}

}  // namespace

OracleVerdict judge(const EngraveCase& engraveCase, const EngravableModel& model, const Result<EngraveResult>& result) {
  if (result) return judgeSolid(engraveCase, model, *result);
  const Error& error = result.error();
  if (sentence(error.message).empty() || hint(error.message).empty())
    return {"refused", "without a message or a hint: " + sentence(error.message)};
  if (error.kind == ErrorKind::NoSolution) return judgeNoSolution(engraveCase, model, error);
  if (error.kind == ErrorKind::BadInput) return judgeBadInput(engraveCase, model, error);
  return {"error", "no typed refusal: " + sentence(error.message)};
}

OracleVerdict runEngraveCase(const EngraveCase& engraveCase) {
  auto prepared = prepareModel(shapes::soupOf(engraveCase.mesh), {});
  if (!prepared) return {"not prepared", sentence(prepared.error().message)};
  const auto model = EngravableModel::upload(std::move(*prepared));
  return judge(engraveCase, *model, engrave(model, engraveCase.request));
}

OracleVerdict runCarvingCase(const EngraveCase& engraveCase, Choices& choices) {
  auto prepared = prepareModel(shapes::soupOf(engraveCase.mesh), {});
  if (!prepared) return {"not prepared", sentence(prepared.error().message)};
  const auto shared = EngravableModel::create(std::move(*prepared), nullptr);
  const EngravableModel& model = *shared;
  if (const Status engravable = model.prepared.engravable(); !engravable)
    return judge(engraveCase, model, tl::unexpected(engravable.error()));
  const auto symbol = encodeSymbol(engraveCase.request.code.text, engraveCase.request.code.symbol);
  if (!symbol) return judge(engraveCase, model, tl::unexpected(symbol.error()));

  EngraveCase directed = engraveCase;
  if (!directed.request.placement.direction) {
    const auto nearest = closestPoint(model.prepared.mesh, engraveCase.request.placement.centreMm);
    directed.request.placement.direction = triangleNormal(model.prepared.mesh, nearest->triangle);
  }
  directed.request.placement.beyondMm = engraveCase.request.depth.minWallMm + kDeepestMm;
  PlacementSearch search(model.prepared, *model.renderer, symbol->size, directed.request.placement);
  if (const Result<bool> placed = search.step(); !placed) return judge(directed, model, tl::unexpected(placed.error()));
  return judge(directed, model, carve(directed, model, search.placement(), *symbol, choices));
}

}  // namespace qrelief
