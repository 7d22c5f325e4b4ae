// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/prepare.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/parallel.h"
#include "math/float_step.h"
#include "mesh/report_findings.h"
#include "mesh/upright.h"
#include "mesh/weld.h"
#include "message_codes/model.h"

namespace qrelief {
namespace {

constexpr double kImplausibleMm = 1e7;  // 10 km
constexpr double kHugeMm = 2000;
constexpr double kTinyMm = 10;                               // no printable code fits
constexpr std::size_t kMaxTriangles = std::size_t{1} << 30;  // half-edges are numbered in 32 bits
constexpr double kCollinearFraction = 1e-9;  // height of a triangle / its longest side, from rounding alone
constexpr double kMmPerKm = 1e6;

Status checkSoup(const PolygonSoup& soup, const PrepareOptions& options) {
  if (!(options.scaleToMm > 0) || !std::isfinite(options.scaleToMm))
    return fail(ErrorKind::BadUsage, message<"scale-not-positive">(with::number<"scale">(options.scaleToMm)));
  for (const std::optional<double>& mm : {options.repair.weldToleranceMm, options.repair.maxHoleMm})
    if (mm && !(*mm >= 0 && std::isfinite(*mm)))
      return fail(ErrorKind::BadUsage, message<"repair-tolerance-senseless">(with::lengthMm<"tolerance">(*mm)));
  if (soup.triangles.empty()) return badInput(message<"model-no-triangle">());
  if (soup.triangles.size() > kMaxTriangles || soup.positions.size() > 3 * kMaxTriangles)
    return badInput(message<"model-too-many-triangles">(with::count<"triangles">(soup.triangles.size()),
                                                        with::count<"most">(kMaxTriangles)));
  for (std::size_t i = 0; i < soup.positions.size(); ++i) {
    const Vec3 p = soup.positions[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return badInput(message<"model-vertex-not-finite">(with::index<"vertex">(i + 1), with::place<"at">(p)));
  }
  return {};
}

std::vector<char> usedPositions(const PolygonSoup& soup) {
  std::vector<char> used(soup.positions.size(), 0);
  for (const Triangle& t : soup.triangles)
    for (const std::uint32_t v : t) used[v] = 1;
  return used;
}

/// Refuses models too large for 32-bit floats or for any printer.
Status checkExtent(const Box3& boxMm, double scaleToMm) {
  const Vec3 size = boxMm.size();
  const double largest = std::max({size.x, size.y, size.z});
  const Vec3 far = glm::max(glm::abs(boxMm.min), glm::abs(boxMm.max));
  if (largest > kImplausibleMm)
    return badInput(message<"model-implausibly-large">(with::number<"km">(largest / kMmPerKm),
                                                       with::number<"fileUnits">(largest / scaleToMm)));
  if (const double farthest = std::max({far.x, far.y, far.z}); farthest > kImplausibleMm)
    return badInput(message<"model-too-far-away">(with::number<"km">(farthest / kMmPerKm),
                                                  with::lengthMm<"step">(floatStepMm(farthest)),
                                                  with::number<"maxKm">(kImplausibleMm / kMmPerKm)));
  if (largest == 0) return badInput(message<"model-no-extent">());
  return {};
}

/// Scales, rounds and welds the mesh within each body; leaves out unused positions.
Result<Mesh> weldedMesh(const PolygonSoup& soup, double scaleToMm, FindingList& findings) {
  const std::vector<char> used = usedPositions(soup);
  Box3 box;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) box.add(soup.positions[i] * scaleToMm);
  QRELIEF_TRY(checkExtent(box, scaleToMm));
  if (const auto unused = std::count(used.begin(), used.end(), 0); unused > 0)
    findings.note(message<"unused-vertices">(with::count<"count">(unused)));
  return meshOfSoup(soup, scaleToMm);
}

void reportExtent(PreparedModel& model, FindingList& findings) {
  const Box3 box = boundingBox(model.mesh);
  const Vec3 size = box.size();
  const double largest = std::max({size.x, size.y, size.z});
  if (largest < kTinyMm) {
    model.unitSuggestions = suggestUnits(size, model.scaleToMm);
    findings.warn(
        message<"tiny">(with::extentMm<"size">(size), with::cause<"advice">(unitAdvice(model.unitSuggestions))));
  }
  if (largest > kHugeMm) {
    model.unitSuggestions = suggestUnits(size, model.scaleToMm);
    findings.warn(
        message<"huge">(with::extentMm<"size">(size), with::cause<"advice">(smallerUnitAdvice(model.unitSuggestions))));
  }
  if (standsOnY(model.mesh)) findings.warn(message<"stands-on-y">());
  const Vec3 far = glm::max(glm::abs(box.min), glm::abs(box.max));
  const double farthest = std::max({far.x, far.y, far.z});
  const double step = floatStepMm(farthest);
  if (step > kCoarseStepMm && farthest > 4 * largest)
    findings.warn(message<"far-away">(with::lengthMm<"distance">(farthest), with::lengthMm<"step">(step)));
}

bool hasArea(const PolygonSoup& soup, const Triangle& t) {
  const Vec3 a = soup.positions[t[0]], u = soup.positions[t[1]] - a, v = soup.positions[t[2]] - a;
  const double longest = std::max({glm::length(u), glm::length(v), glm::length(v - u)});
  return glm::length(glm::cross(u, v)) > kCollinearFraction * longest * longest;
}

/// Returns the reason why no triangle is left.
Message nothingLeft(const PolygonSoup& soup, const Cleaning& cleaning) {
  const std::size_t triangles = soup.triangles.size();
  if (cleaning.duplicates > 0) return message<"model-no-thickness">(with::count<"count">(triangles));
  const bool isRounded =
      std::any_of(soup.triangles.begin(), soup.triangles.end(), [&](const Triangle& t) { return hasArea(soup, t); });
  if (isRounded) return message<"area-lost-in-rounding">(with::count<"count">(triangles));
  return message<"model-no-area">(with::count<"count">(triangles));
}

/// Sets the model's bodies: those that the file names, or else the closed shells with their cavities.
void setBodies(const PolygonSoup& soup, const Repaired& repaired, PreparedModel& model) {
  if (!soup.bodies.empty()) {
    model.bodies = soup.bodies;
    if (!soup.bodyOf.empty())
      for (const std::uint32_t t : repaired.origin) model.mesh.bodyOf.push_back(soup.bodyOf[t]);
    return;
  }
  const Consistency& consistency = repaired.consistency;
  if (consistency.shells.count < 2 || !repaired.closed() || !repaired.outwardness.nestingKnown) {
    model.bodies.emplace_back();
    return;
  }
  constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::uint32_t> bodyOfShell(consistency.shells.count, kNone);
  for (const std::uint32_t shell : consistency.shells.of) {
    std::uint32_t& body = bodyOfShell[repaired.outwardness.solidOf[shell]];
    if (body == kNone) {
      body = static_cast<std::uint32_t>(model.bodies.size());
      model.bodies.push_back({.name = {}, .part = 0, .isShell = true});
    }
    model.mesh.bodyOf.push_back(body);
  }
  if (model.bodies.size() == 1) model.mesh.bodyOf.clear();
}

/// Returns the colours of the triangles; none unless there are two different ones.
std::vector<std::optional<Colour>> coloursOf(const PolygonSoup& soup, std::span<const std::uint32_t> origin) {
  if (soup.colours.empty()) return {};
  std::vector<std::optional<Colour>> colours;
  colours.reserve(origin.size());
  for (const std::uint32_t t : origin) colours.push_back(soup.colours[t]);
  const bool differ = std::adjacent_find(colours.begin(), colours.end(), std::not_equal_to<>()) != colours.end();
  return differ ? std::move(colours) : std::vector<std::optional<Colour>>();
}

/// Returns, for each body, whether a repair added, dropped or changed a triangle.
std::vector<char> repairedBodies(const PolygonSoup& soup, const Mesh& before, const Repaired& repaired) {
  const auto bodyOf = [&](std::uint32_t t) { return soup.bodyOf.empty() ? 0 : soup.bodyOf[t]; };
  const auto sameCorners = [&](std::uint32_t t) {
    for (int k = 0; k < 3; ++k)
      if (repaired.mesh.corner(t, k) != before.corner(repaired.origin[t], k)) return false;
    return true;
  };
  std::vector<std::size_t> triangles(soup.bodies.size(), 0);  // those before without those that stayed
  for (std::uint32_t t = 0; t < before.triangles.size(); ++t) ++triangles[bodyOf(t)];
  std::vector<char> wasRepaired(soup.bodies.size(), 0);
  for (std::uint32_t t = 0; t < repaired.origin.size(); ++t) {
    const std::uint32_t body = bodyOf(repaired.origin[t]);
    --triangles[body];
    if (!sameCorners(t)) wasRepaired[body] = 1;
  }
  for (std::size_t b = 0; b < triangles.size(); ++b)
    if (triangles[b] != 0) wasRepaired[b] = 1;
  return wasRepaired;
}

}  // namespace

const char* severityName(Finding::Severity severity) {
  switch (severity) {
    case Finding::Severity::Note:
      return "note";
    case Finding::Severity::Warning:
      return "warning";
    case Finding::Severity::Blocking:
      break;
  }
  return "blocking";
}

std::vector<std::size_t> PreparedModel::bodySizes() const {
  std::vector<std::size_t> sizes(bodies.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) ++sizes[mesh.body(t)];
  return sizes;
}

Status PreparedModel::engravable() const {
  for (const Finding& finding : findings)
    if (finding.severity == Finding::Severity::Blocking) return badInput(finding.message);
  return {};
}

Result<PreparedModel> prepareModel(const PolygonSoup& soup, const PrepareOptions& options) {
  QRELIEF_TRY(checkSoup(soup, options));
  FindingList findings(options.scaleToMm);
  Result<Mesh> welded = weldedMesh(soup, options.scaleToMm, findings);
  QRELIEF_TRY(welded);

  const Mesh unrepaired = soup.source ? *welded : Mesh();
  Result<Repaired> repaired = repairMesh(std::move(*welded), soup.bodyOf, options.repair);
  QRELIEF_TRY(repaired);
  if (repaired->mesh.triangles.empty()) return badInput(nothingLeft(soup, repaired->cleaning));

  PreparedModel model;
  model.scaleToMm = options.scaleToMm;
  reportRepairs(*repaired, options.repair, findings);
  setBodies(soup, *repaired, model);
  model.colours = coloursOf(soup, repaired->origin);
  model.source = soup.source;
  if (model.source) {
    model.wasRepaired = repairedBodies(soup, unrepaired, *repaired);
    model.originOfTriangle = std::move(repaired->origin);
  }
  model.mesh.positions = std::move(repaired->mesh.positions);
  model.mesh.triangles = std::move(repaired->mesh.triangles);
  model.adjacency = std::move(repaired->adjacency);
  model.shells = repaired->consistency.shells.count;
  model.crossesItself = repaired->untangling.pairs > 0 && !repaired->untangling.mended;
  model.hasCrossings = model.crossesItself || repaired->overlaps.any();
  model.crossings = std::move(repaired->crossings);
  parallelFor(2, [&](int k) {
    if (k == 0)
      model.normals = vertexNormals(model.mesh);
    else
      model.clusters = std::make_shared<const ClusteredTriangles>(clusterTriangles(model.mesh));
  });
  reportExtent(model, findings);
  model.findings = findings.take();
  return model;
}

}  // namespace qrelief
