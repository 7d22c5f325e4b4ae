// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/prepare.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/report_findings.h"
#include "mesh/weld.h"

namespace qrelief {
namespace {

constexpr double kImplausibleMm = 1e7;  // 10 km
constexpr double kHugeMm = 2000;
constexpr double kTinyMm = 10;       // no printable code fits
constexpr double kCoarseMm = 0.001;  // a hundredth of a layer: coarser coordinates become visible
constexpr std::size_t kMaxTriangles = std::size_t{1} << 30;  // half-edges are numbered in 32 bits
constexpr double kCollinearFraction = 1e-9;  // height of a triangle / its longest side, from rounding alone
constexpr double kMmPerKm = 1e6;

/// Returns the largest distance between neighbouring 32-bit floats up to there.
double floatStepMm(double farthestMm) { return farthestMm * std::numeric_limits<float>::epsilon(); }

Status checkSoup(const PolygonSoup& soup, const PrepareOptions& options) {
  if (!(options.scaleToMm > 0) || !std::isfinite(options.scaleToMm))
    return fail(ErrorKind::BadUsage, message("scale-not-positive", with::number<"scale">(options.scaleToMm)));
  for (const std::optional<double>& mm : {options.repair.weldToleranceMm, options.repair.maxHoleMm})
    if (mm && !(*mm >= 0 && std::isfinite(*mm)))
      return fail(ErrorKind::BadUsage, message("repair-tolerance-senseless", with::lengthMm<"tolerance">(*mm)));
  if (soup.triangles.empty()) return badInput(message("model-no-triangle"));
  if (soup.triangles.size() > kMaxTriangles || soup.positions.size() > 3 * kMaxTriangles)
    return badInput(message("model-too-many-triangles", with::count<"triangles">(soup.triangles.size()),
                            with::count<"most">(kMaxTriangles)));
  for (std::size_t i = 0; i < soup.positions.size(); ++i) {
    const Vec3 p = soup.positions[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return badInput(message("model-vertex-not-finite", with::count<"vertex">(i + 1), with::place<"at">(p)));
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
    return badInput(message("model-implausibly-large", with::number<"km">(largest / kMmPerKm),
                            with::number<"fileUnits">(largest / scaleToMm)));
  if (const double farthest = std::max({far.x, far.y, far.z}); farthest > kImplausibleMm)
    return badInput(message("model-too-far-away", with::number<"km">(farthest / kMmPerKm),
                            with::lengthMm<"step">(floatStepMm(farthest)),
                            with::number<"maxKm">(kImplausibleMm / kMmPerKm)));
  if (largest == 0) return badInput(message("model-no-extent"));
  return {};
}

/// Scales, rounds and welds the mesh; leaves out unused positions.
Result<Mesh> weldedMesh(const PolygonSoup& soup, double scaleToMm, FindingList& findings) {
  const std::vector<char> used = usedPositions(soup);
  Box3 box;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) box.add(soup.positions[i] * scaleToMm);
  if (Status s = checkExtent(box, scaleToMm); !s) return tl::unexpected(s.error());

  std::vector<Vec3f> points;
  std::vector<std::uint32_t> newIndex(used.size(), 0);
  points.reserve(used.size());
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    newIndex[i] = static_cast<std::uint32_t>(points.size());
    points.emplace_back(soup.positions[i] * scaleToMm);
  }
  Welding welding = weldEqual(points);
  Mesh mesh;
  mesh.positions = std::move(welding.positions);
  mesh.triangles.reserve(soup.triangles.size());
  for (const auto& [a, b, c] : soup.triangles)
    mesh.triangles.push_back(
        {welding.indexOf[newIndex[a]], welding.indexOf[newIndex[b]], welding.indexOf[newIndex[c]]});
  if (const std::size_t unused = used.size() - points.size(); unused > 0)
    findings.note(message("unused-vertices", with::count<"count">(unused)));
  return mesh;
}

void reportExtent(PreparedModel& model, FindingList& findings) {
  const Box3 box = boundingBox(model.mesh);
  const Vec3 size = box.size();
  const double largest = std::max({size.x, size.y, size.z});
  if (largest < kTinyMm) {
    model.unitSuggestions = suggestUnits(size, model.scaleToMm);
    findings.warn(
        message("tiny", with::extentMm<"size">(size), with::cause<"advice">(unitAdvice(model.unitSuggestions))));
  }
  if (largest > kHugeMm) findings.warn(message("huge", with::extentMm<"size">(size)));
  const Vec3 far = glm::max(glm::abs(box.min), glm::abs(box.max));
  const double farthest = std::max({far.x, far.y, far.z});
  const double step = floatStepMm(farthest);
  if (step > kCoarseMm && farthest > 4 * largest)
    findings.warn(message("far-away", with::lengthMm<"distance">(farthest), with::lengthMm<"step">(step)));
}

/// Returns the part of each triangle of the file; empty: one part only.
std::vector<std::uint32_t> partsOf(const PolygonSoup& soup) {
  std::vector<std::uint32_t> parts;
  if (soup.parts.size() < 2) return parts;
  parts.resize(soup.triangles.size(), 0);
  for (std::size_t i = 0; i < soup.parts.size(); ++i)
    std::fill(parts.begin() + static_cast<std::ptrdiff_t>(soup.parts[i].firstTriangle), parts.end(),
              static_cast<std::uint32_t>(i));
  return parts;
}

bool hasArea(const PolygonSoup& soup, const Triangle& t) {
  const Vec3 a = soup.positions[t[0]], u = soup.positions[t[1]] - a, v = soup.positions[t[2]] - a;
  const double longest = std::max({glm::length(u), glm::length(v), glm::length(v - u)});
  return glm::length(glm::cross(u, v)) > kCollinearFraction * longest * longest;
}

/// Returns the reason why no triangle is left.
Message nothingLeft(const PolygonSoup& soup, const Cleaning& cleaning) {
  const std::size_t triangles = soup.triangles.size();
  if (cleaning.duplicates > 0) return message("model-no-thickness", with::count<"count">(triangles));
  const bool isRounded =
      std::any_of(soup.triangles.begin(), soup.triangles.end(), [&](const Triangle& t) { return hasArea(soup, t); });
  if (isRounded) return message("area-lost-in-rounding", with::count<"count">(triangles));
  return message("model-no-area", with::count<"count">(triangles));
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

Status PreparedModel::engravable() const {
  for (const Finding& finding : findings)
    if (finding.severity == Finding::Severity::Blocking) return badInput(finding.message);
  return {};
}

Result<PreparedModel> prepareModel(const PolygonSoup& soup, const PrepareOptions& options) {
  if (Status s = checkSoup(soup, options); !s) return tl::unexpected(s.error());
  FindingList findings(options.scaleToMm);
  Result<Mesh> welded = weldedMesh(soup, options.scaleToMm, findings);
  if (!welded) return tl::unexpected(welded.error());

  const std::vector<std::uint32_t> parts = partsOf(soup);
  const Mesh unrepaired = soup.source ? *welded : Mesh();
  Result<Repaired> repaired = repairMesh(std::move(*welded), parts, options.repair);
  if (!repaired) return tl::unexpected(repaired.error());
  if (repaired->mesh.triangles.empty()) return badInput(nothingLeft(soup, repaired->cleaning));

  PreparedModel model;
  model.scaleToMm = options.scaleToMm;
  if (!parts.empty())
    for (const std::uint32_t t : repaired->origin) model.partOfTriangle.push_back(parts[t]);
  reportRepairs(*repaired, options.repair, soup.parts, model.partOfTriangle, findings);
  model.source = soup.source;
  if (model.source) {
    model.originOfTriangle = std::move(repaired->origin);
    model.equalsSource =
        unrepaired.positions == repaired->mesh.positions && unrepaired.triangles == repaired->mesh.triangles;
  }
  model.mesh = std::move(repaired->mesh);
  model.adjacency = std::move(repaired->adjacency);
  model.shells = repaired->consistency.shells.count;
  model.crossesItself = repaired->untangling.pairs > 0 && !repaired->untangling.mended;
  model.normals = vertexNormals(model.mesh);
  reportExtent(model, findings);
  model.findings = findings.take();
  return model;
}

}  // namespace qrelief
