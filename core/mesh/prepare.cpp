// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/prepare.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "mesh/clean.h"
#include "mesh/defects.h"
#include "mesh/orient.h"
#include "mesh/untangle.h"
#include "mesh/weld.h"

namespace qrelief {
namespace {

constexpr double kImplausibleMm = 1e7;  // 10 km
constexpr double kHugeMm = 2000;
constexpr double kTinyMm = 5;
constexpr double kCoarseMm = 0.001;  // a hundredth of a layer: coarser coordinates begin to show
constexpr std::size_t kMaxTriangles = std::size_t{1} << 30;  // half-edges are numbered in 32 bits

/// Everything that is said about one model; places are given in file units.
class FindingList {
 public:
  explicit FindingList(double scaleToMm) : scale_(scaleToMm) {}

  void note(std::string code, std::size_t count, std::string message) {
    add(Finding::Severity::Note, std::move(code), count, std::move(message), {});
  }
  void warn(std::string code, std::size_t count, std::string message, std::string hint) {
    add(Finding::Severity::Warning, std::move(code), count, std::move(message), std::move(hint));
  }
  void block(std::string code, std::size_t count, std::string message, std::string hint) {
    add(Finding::Severity::Blocking, std::move(code), count, std::move(message), std::move(hint));
  }
  std::string place(Vec3 p) const {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x / scale_, p.y / scale_, p.z / scale_);
  }
  std::vector<Finding> take() { return std::move(findings_); }

 private:
  void add(Finding::Severity severity, std::string code, std::size_t count, std::string message, std::string hint) {
    findings_.push_back({severity, std::move(code), count, std::move(message), std::move(hint)});
  }

  double scale_;
  std::vector<Finding> findings_;
};

/// "1 edge", "7 edges".
std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

Status checkSoup(const PolygonSoup& soup, const PrepareOptions& options) {
  if (!(options.scaleToMm > 0) || !std::isfinite(options.scaleToMm))
    return fail(ErrorCode::BadUsage, fmt::format("The scale is {}; it has to be a positive number", options.scaleToMm));
  if (soup.triangles.empty()) return fail(ErrorCode::BadInput, "The model has no triangle");
  if (soup.triangles.size() > kMaxTriangles || soup.positions.size() > 3 * kMaxTriangles)
    return fail(
        ErrorCode::BadInput,
        fmt::format("The model has {} triangles; at most {} can be handled", soup.triangles.size(), kMaxTriangles),
        "Reduce (decimate) the model first");
  for (std::size_t i = 0; i < soup.positions.size(); ++i) {
    const Vec3 p = soup.positions[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return fail(ErrorCode::BadInput,
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
    return fail(ErrorCode::BadInput,
                fmt::format("The model is {:.4g} mm across ({:.4g} in file units), which is implausible", largest,
                            largest / scaleToMm),
                "Say how many millimetres a file unit is, with --scale or --units");
  if (const double farthest = std::max({far.x, far.y, far.z}); farthest > kImplausibleMm)
    return fail(ErrorCode::BadInput, fmt::format("The model lies {:.4g} mm away from the origin", farthest),
                "Move it to the origin, or say how many millimetres a file unit is with --scale");
  if (largest == 0) return fail(ErrorCode::BadInput, "The model has no extent: all its vertices are in one place");
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

void reportExtent(const Mesh& mesh, double scaleToMm, FindingList& findings) {
  const Box3 box = boundingBox(mesh);
  const Vec3 size = box.size();
  const double largest = std::max({size.x, size.y, size.z});
  const std::string extent = fmt::format("{:.4g} x {:.4g} x {:.4g} mm", size.x, size.y, size.z);
  if (largest < kTinyMm)
    findings.warn("tiny", 1, fmt::format("The model is tiny: {}", extent),
                  scaleToMm == 1 ? "If its units are metres, use --units m; inches: --units in; else --scale"
                                 : "Check --scale or --units");
  if (largest > kHugeMm)
    findings.warn("huge", 1, fmt::format("The model is huge: {}", extent), "Check its units; --scale makes it smaller");
  const Vec3 far = glm::max(glm::abs(box.min), glm::abs(box.max));
  const double farthest = std::max({far.x, far.y, far.z});
  const double step = farthest * std::numeric_limits<float>::epsilon();
  if (step > kCoarseMm && farthest > 4 * largest)
    findings.warn("far-away", 1,
                  fmt::format("The model lies {:.4g} mm from the origin, where 32-bit coordinates are {:.2g} mm apart",
                              farthest, step),
                  "Move the model to the origin before exporting it");
}

void reportCleaning(const Cleaning& cleaning, FindingList& findings) {
  if (cleaning.degenerate > 0)
    findings.warn(
        "degenerate-triangles", cleaning.degenerate,
        counted(cleaning.degenerate, "triangle without area was", "triangles without area were") +
            (cleaning.mended == 0 ? std::string(" dropped")
                                  : fmt::format(" removed, {} of them into their neighbours", cleaning.mended)) +
            fmt::format(", one at {}", findings.place(*cleaning.degenerateAt)),
        "Nothing needs to be done");
  if (cleaning.duplicates > 0)
    findings.warn("duplicate-triangles", cleaning.duplicates,
                  counted(cleaning.duplicates, "triangle was", "triangles were") +
                      fmt::format(" dropped because another has the same corners, one at {}",
                                  findings.place(*cleaning.duplicateAt)),
                  "Nothing needs to be done");
}

void reportDefects(const Defects& defects, FindingList& findings) {
  if (defects.openEdges > 0)
    findings.block(
        "open-edges", defects.openEdges,
        fmt::format("The surface is not closed: {} around {}, one at {}",
                    counted(defects.openEdges, "open edge", "open edges"),
                    counted(defects.holes, "hole or gap", "holes or gaps"), findings.place(defects.openAt)),
        "Close the holes and merge nearby vertices in a mesh program (\"make solid\", \"repair\"), then try again");
  if (defects.nonManifoldEdges > 0)
    findings.block("non-manifold-edges", defects.nonManifoldEdges,
                   counted(defects.nonManifoldEdges, "edge belongs", "edges belong") +
                       fmt::format(" to more than two triangles, one at {}", findings.place(defects.nonManifoldEdgeAt)),
                   "Remove inner walls and doubled faces in a mesh program (\"make manifold\"), then try again");
  if (defects.nonManifoldVertices > 0)
    findings.warn("non-manifold-vertices", defects.nonManifoldVertices,
                  fmt::format("At {} parts of the surface touch in a single point, as at {}; left as it is",
                              counted(defects.nonManifoldVertices, "vertex", "vertices"),
                              findings.place(defects.nonManifoldVertexAt)),
                  "Slicers print it; strict checkers will call the result not manifold there");
}

void reportOrientation(const Mesh& mesh, const Consistency& consistency, const Outwardness& outwardness,
                       FindingList& findings) {
  const auto place = [&](std::uint32_t t) { return findings.place(mesh.corner(t, 0)); };
  if (consistency.oneSided)
    findings.block("one-sided", 1,
                   fmt::format("The surface has only one side, like a Moebius strip; one of its triangles is at {}",
                               place(*consistency.oneSided)),
                   "Rebuild that part in a mesh program; it bounds no volume");
  if (consistency.turned > 0)
    findings.warn("misoriented-triangles", consistency.turned,
                  counted(consistency.turned, "triangle was", "triangles were") +
                      fmt::format(" turned round to face the same way as the neighbours, one at {}",
                                  place(*consistency.turnedExample)),
                  "Nothing needs to be done");
  if (outwardness.insideOut > 0)
    findings.warn("inside-out", outwardness.insideOut,
                  counted(outwardness.insideOut, "shell was", "shells were") +
                      fmt::format(" inside out and turned round, one at {}", place(*outwardness.insideOutExample)),
                  "Nothing needs to be done");
  if (outwardness.nestedSolids > 0)
    findings.warn("nested-solids", outwardness.nestedSolids,
                  counted(outwardness.nestedSolids, "shell lies", "shells lie") +
                      fmt::format(" inside another and bound solid material twice, one at {}; left as it is",
                                  place(*outwardness.nestedExample)),
                  "If it is meant to be hollow there, turn the inner shell's faces inwards");
  if (outwardness.cavities > 0)
    findings.note("cavities", outwardness.cavities,
                  counted(outwardness.cavities, "inner shell bounds a cavity", "inner shells bound cavities") +
                      fmt::format(", one at {}", place(*outwardness.cavityExample)));
  if (consistency.shells.count > 1)
    findings.note("several-shells", consistency.shells.count,
                  fmt::format("The model consists of {} separate shells", consistency.shells.count));
}

/// Crossing triangles are no reason to refuse: carving away from them works all the same.
void reportUntangling(const Untangling& untangling, FindingList& findings) {
  if (untangling.pairs == 0) return;
  const std::string pairs = (untangling.atLeast ? "At least " : "") +
                            counted(untangling.pairs, "pair of triangles crosses", "pairs of triangles cross") +
                            fmt::format(" each other, the first near {}", findings.place(untangling.at));
  if (untangling.mended)
    findings.warn("self-intersections-mended", untangling.pairs,
                  fmt::format("{}; mended: {} moved, by {:.2g} mm at most", pairs,
                              counted(untangling.moved, "vertex was", "vertices were"), untangling.largestMoveMm),
                  "Nothing needs to be done");
  else
    findings.warn("self-intersections", untangling.pairs, pairs + "; left as they are",
                  "Place the code away from them; to be rid of them, unite the model's parts in a CAD program");
}

}  // namespace

Status PreparedModel::engravable() const {
  for (const Finding& finding : findings)
    if (finding.severity == Finding::Severity::Blocking)
      return fail(ErrorCode::BadInput, finding.message, finding.hint);
  return {};
}

Result<PreparedModel> prepareModel(const PolygonSoup& soup, const PrepareOptions& options) {
  if (Status s = checkSoup(soup, options); !s) return tl::unexpected(s.error());
  FindingList findings(options.scaleToMm);
  Result<Mesh> welded = weldedMesh(soup, options.scaleToMm, findings);
  if (!welded) return tl::unexpected(welded.error());

  PreparedModel model;
  model.mesh = std::move(*welded);
  const Cleaning cleaning = cleanTriangles(model.mesh);
  if (model.mesh.triangles.empty())
    return fail(ErrorCode::BadInput, fmt::format("None of the model's {} triangles has an area", soup.triangles.size()),
                "Check the scale: as 32-bit floats in mm its vertices coincide");
  dropUnused(model.mesh);
  const EdgeTable edges = buildEdgeTable(model.mesh.triangles);
  model.adjacency = buildAdjacency(model.mesh.triangles, edges);
  const Defects defects = findDefects(model.mesh, edges, model.adjacency);
  const Consistency consistency = makeConsistent(model.mesh.triangles, model.adjacency);
  const Outwardness outwardness = orientOutwards(model.mesh, model.adjacency, consistency);
  const bool closed = defects.openEdges == 0 && defects.nonManifoldEdges == 0 && !consistency.oneSided;
  const Result<Untangling> untangling = closed ? untangle(model.mesh) : Untangling{};
  if (!untangling) return tl::unexpected(untangling.error());
  model.shells = consistency.shells.count;
  model.normals = vertexNormals(model.mesh);

  reportDefects(defects, findings);
  reportOrientation(model.mesh, consistency, outwardness, findings);
  reportCleaning(cleaning, findings);
  reportUntangling(*untangling, findings);
  reportExtent(model.mesh, options.scaleToMm, findings);
  model.findings = findings.take();
  std::stable_sort(model.findings.begin(), model.findings.end(), [](const Finding& a, const Finding& b) {
    return a.severity > b.severity;  // what blocks comes first
  });
  return model;
}

}  // namespace qrelief
