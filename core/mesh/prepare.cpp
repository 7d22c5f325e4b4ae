// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/prepare.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "mesh/report_findings.h"
#include "mesh/weld.h"

namespace qrelief {
namespace {

constexpr double kImplausibleMm = 1e7;  // 10 km
constexpr double kHugeMm = 2000;
constexpr double kTinyMm = 10;                                // no code that can be printed fits
constexpr double kLeastPrintedMm = 15, kMostPrintedMm = 500;  // what a unit may make of a tiny model
constexpr double kCoarseMm = 0.001;  // a hundredth of a layer: coarser coordinates begin to show
constexpr std::size_t kMaxTriangles = std::size_t{1} << 30;  // half-edges are numbered in 32 bits

Status checkSoup(const PolygonSoup& soup, const PrepareOptions& options) {
  if (!(options.scaleToMm > 0) || !std::isfinite(options.scaleToMm))
    return fail(ErrorKind::BadUsage, fmt::format("The scale is {}; it has to be a positive number", options.scaleToMm));
  for (const std::optional<double>& mm : {options.repair.weldToleranceMm, options.repair.maxHoleMm})
    if (mm && !(*mm >= 0 && std::isfinite(*mm)))
      return fail(ErrorKind::BadUsage, fmt::format("A tolerance of {} mm for repairs makes no sense", *mm),
                  "Give 0 or more, in mm");
  if (soup.triangles.empty()) return fail(ErrorKind::BadInput, "The model has no triangle");
  if (soup.triangles.size() > kMaxTriangles || soup.positions.size() > 3 * kMaxTriangles)
    return fail(
        ErrorKind::BadInput,
        fmt::format("The model has {} triangles; at most {} can be handled", soup.triangles.size(), kMaxTriangles),
        "Reduce (decimate) the model first");
  for (std::size_t i = 0; i < soup.positions.size(); ++i) {
    const Vec3 p = soup.positions[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return fail(ErrorKind::BadInput,
                  fmt::format("Vertex {} is at ({}, {}, {}), which is not finite", i + 1, p.x, p.y, p.z),
                  "Export the model again; something went wrong when it was made");
  }
  return {};
}

std::vector<char> usedPositions(const PolygonSoup& soup) {
  std::vector<char> used(soup.positions.size(), 0);
  for (const Triangle& t : soup.triangles)
    for (const std::uint32_t v : t) used[v] = 1;
  return used;
}

/// Refuses what no 32-bit float or no printer can hold.
Status checkExtent(const Box3& boxMm, double scaleToMm) {
  const Vec3 size = boxMm.size();
  const double largest = std::max({size.x, size.y, size.z});
  const Vec3 far = glm::max(glm::abs(boxMm.min), glm::abs(boxMm.max));
  if (largest > kImplausibleMm)
    return fail(ErrorKind::BadInput,
                fmt::format("The model is {:.4g} mm across ({:.4g} in file units), which is implausible", largest,
                            largest / scaleToMm),
                "Say how many millimetres a file unit is, with --scale or --units");
  if (const double farthest = std::max({far.x, far.y, far.z}); farthest > kImplausibleMm)
    return fail(ErrorKind::BadInput, fmt::format("The model lies {:.4g} mm away from the origin", farthest),
                "Move it to the origin, or say how many millimetres a file unit is with --scale");
  if (largest == 0) return fail(ErrorKind::BadInput, "The model has no extent: all its vertices are in one place");
  return {};
}

/// Scaled, rounded and welded; unused positions are left out.
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
    findings.note("unused-vertices", unused,
                  counted(unused, "vertex that no face uses was dropped", "vertices that no face uses were dropped"));
  return mesh;
}

/// Units in which a tiny model would have a size that people print.
std::vector<UnitSuggestion> suggestUnits(double largestMm, double scaleToMm) {
  std::vector<UnitSuggestion> suggestions;
  for (const auto& [unit, name, mm] :
       {UnitSuggestion{"m", "metres", 1000}, UnitSuggestion{"in", "inches", 25.4}, UnitSuggestion{"cm", "cm", 10}}) {
    const double size = largestMm / scaleToMm * mm;
    if (mm != scaleToMm && size >= kLeastPrintedMm && size <= kMostPrintedMm) suggestions.push_back({unit, name, mm});
  }
  return suggestions;
}

void reportTiny(PreparedModel& model, Vec3 size, double scaleToMm, FindingList& findings) {
  model.unitSuggestions = suggestUnits(std::max({size.x, size.y, size.z}), scaleToMm);
  std::string hint;
  for (const auto& [unit, name, mm] : model.unitSuggestions) {
    const Vec3 then = size * (mm / scaleToMm);
    hint += fmt::format("{} {}, it is {:.3g} x {:.3g} x {:.3g} mm: --units {}", hint.empty() ? "In" : "; in", name,
                        then.x, then.y, then.z, unit);
  }
  findings.warn("tiny", 1, fmt::format("The model is tiny: {:.4g} x {:.4g} x {:.4g} mm", size.x, size.y, size.z),
                hint.empty() ? "Check its units; --scale makes it larger" : hint + "; or use --scale");
}

void reportExtent(PreparedModel& model, double scaleToMm, FindingList& findings) {
  const Box3 box = boundingBox(model.mesh);
  const Vec3 size = box.size();
  const double largest = std::max({size.x, size.y, size.z});
  if (largest < kTinyMm) reportTiny(model, size, scaleToMm, findings);
  if (largest > kHugeMm)
    findings.warn("huge", 1, fmt::format("The model is huge: {:.4g} x {:.4g} x {:.4g} mm", size.x, size.y, size.z),
                  "Check its units; --scale makes it smaller");
  const Vec3 far = glm::max(glm::abs(box.min), glm::abs(box.max));
  const double farthest = std::max({far.x, far.y, far.z});
  const double step = farthest * std::numeric_limits<float>::epsilon();
  if (step > kCoarseMm && farthest > 4 * largest)
    findings.warn("far-away", 1,
                  fmt::format("The model lies {:.4g} mm from the origin, where 32-bit coordinates are {:.2g} mm apart",
                              farthest, step),
                  "Move the model to the origin before exporting it");
}

/// Which part each triangle of the file belongs to; empty: there is one part only.
std::vector<std::uint32_t> partsOf(const PolygonSoup& soup) {
  std::vector<std::uint32_t> parts;
  if (soup.parts.size() < 2) return parts;
  parts.resize(soup.triangles.size(), 0);
  for (std::size_t i = 0; i < soup.parts.size(); ++i)
    std::fill(parts.begin() + static_cast<std::ptrdiff_t>(soup.parts[i].firstTriangle), parts.end(),
              static_cast<std::uint32_t>(i));
  return parts;
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
    if (finding.severity == Finding::Severity::Blocking)
      return fail(ErrorKind::BadInput, finding.message, finding.hint);
  return {};
}

Result<PreparedModel> prepareModel(const PolygonSoup& soup, const PrepareOptions& options) {
  if (Status s = checkSoup(soup, options); !s) return tl::unexpected(s.error());
  FindingList findings(options.scaleToMm);
  Result<Mesh> welded = weldedMesh(soup, options.scaleToMm, findings);
  if (!welded) return tl::unexpected(welded.error());

  const std::vector<std::uint32_t> parts = partsOf(soup);
  Result<Repaired> repaired = repairMesh(std::move(*welded), parts, options.repair);
  if (!repaired) return tl::unexpected(repaired.error());
  if (repaired->mesh.triangles.empty())
    return fail(ErrorKind::BadInput, fmt::format("None of the model's {} triangles has an area", soup.triangles.size()),
                "Check the scale: as 32-bit floats in mm its vertices coincide");

  PreparedModel model;
  if (!parts.empty())
    for (const std::uint32_t t : repaired->origin) model.partOfTriangle.push_back(parts[t]);
  reportRepairs(*repaired, options.repair, soup.parts, model.partOfTriangle, findings);
  model.mesh = std::move(repaired->mesh);
  model.adjacency = std::move(repaired->adjacency);
  model.shells = repaired->consistency.shells.count;
  model.crossesItself = repaired->untangling.pairs > 0 && !repaired->untangling.mended;
  model.normals = vertexNormals(model.mesh);
  reportExtent(model, options.scaleToMm, findings);
  model.findings = findings.take();
  return model;
}

}  // namespace qrelief
