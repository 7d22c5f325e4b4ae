// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/report_findings.h"

#include <algorithm>
#include <fmt/format.h>

namespace qrelief {
namespace {

constexpr const char* kNothingToDo = "Nothing needs to be done";

/// A repair that was made, or one that was needed and is switched off.
void reportMended(bool allowed, std::string code, std::size_t count, std::string found, std::string done,
                  FindingList& findings) {
  if (allowed)
    findings.warn(std::move(code), count, found + "; " + done, kNothingToDo);
  else
    findings.block(std::move(code), count, found + "; the repair is switched off",
                   "Allow the repair, or mend it in a mesh program");
}

void reportCleaning(const Cleaning& cleaning, bool allowed, FindingList& findings) {
  if (cleaning.degenerate > 0)
    reportMended(
        allowed, "degenerate-triangles", cleaning.degenerate,
        counted(cleaning.degenerate, "triangle has no area", "triangles have no area") +
            fmt::format(", one at {}", findings.place(*cleaning.degenerateAt)),
        cleaning.mended == 0 ? "dropped" : fmt::format("removed, {} of them into their neighbours", cleaning.mended),
        findings);
  if (cleaning.duplicates > 0)
    reportMended(allowed, "duplicate-triangles", cleaning.duplicates,
                 counted(cleaning.duplicates, "triangle has", "triangles have") +
                     fmt::format(" the same corners as another, one at {}", findings.place(*cleaning.duplicateAt)),
                 "dropped", findings);
}

void reportSeams(const Repaired& repaired, FindingList& findings) {
  if (const NearWelding& welding = repaired.welding; welding.moved > 0)
    findings.warn("welded-vertices", welding.moved,
                  counted(welding.moved, "vertex on an open edge lies", "vertices on open edges lie") +
                      fmt::format(" within {} of another, one at {}; made one with it, moved by {} at most",
                                  findings.length(repaired.toleranceMm), findings.place(welding.at),
                                  findings.length(welding.largestMoveMm)),
                  "Nothing needs to be done; the distance is set by --weld-tolerance");
  if (const TJunctionSplit& split = repaired.split; split.vertices > 0)
    findings.warn("t-junctions", split.vertices,
                  counted(split.vertices, "vertex lies", "vertices lie") +
                      fmt::format(" on the open edge of a triangle whose corner it is not, one at {}; the triangle was "
                                  "split there (gaps up to {})",
                                  findings.place(split.at), findings.length(split.largestGapMm)),
                  kNothingToDo);
}

void reportFilling(const Repaired& repaired, FindingList& findings) {
  const HoleFilling& filling = repaired.filling;
  if (filling.filled > 0)
    findings.warn("holes-filled", filling.filled,
                  counted(filling.filled, "hole was", "holes were") +
                      fmt::format(" filled with {}, the largest {} across, at {}",
                                  counted(filling.beside.size(), "triangle", "triangles"),
                                  findings.length(filling.largestFilledMm), findings.place(filling.filledAt)),
                  "Look whether the model is right there; --no-repair holes leaves them open");
  if (filling.tooLarge > 0)
    findings.block(
        "large-openings", filling.tooLarge,
        counted(filling.tooLarge, "opening is", "openings are") +
            fmt::format(" too large to be filled (more than {} across, or {} edges): the largest is {} "
                        "across, has {} edges and starts at {}",
                        findings.length(repaired.maxHoleMm), kMaxHoleEdges, findings.length(filling.largestLeftMm),
                        filling.largestLeftEdges, findings.place(filling.leftAt)),
        "If it is meant to be closed there, close it in a mesh program or raise --max-hole; a surface that "
        "is open by design needs a thickness first (\"shell\", \"solidify\")");
  if (filling.blocked > 0)
    findings.block(
        "holes-left", filling.blocked,
        counted(filling.blocked, "hole", "holes") +
            fmt::format(" cannot be filled without crossing the surface, one at {}", findings.place(filling.blockedAt)),
        "Mend it in a mesh program (\"make solid\", \"repair\")");
}

/// "facet 12", "facets 12, 88 and 90", as the file counts them.
std::string facetsOf(const Repaired& repaired, std::span<const std::uint32_t> triangles) {
  std::vector<std::uint32_t> facets;
  for (const std::uint32_t t : triangles) facets.push_back(repaired.origin[t] + 1);
  std::sort(facets.begin(), facets.end());
  facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  constexpr std::size_t kMostNamed = 6;
  std::string names;
  for (std::size_t i = 0; i < std::min(kMostNamed, facets.size()); ++i)
    names += fmt::format("{}{}", i == 0 ? "" : i + 1 == facets.size() ? " and " : ", ", facets[i]);
  if (facets.size() > kMostNamed) names += ", ...";
  return (facets.size() == 1 ? "facet " : "facets ") + names;
}

/// Which parts touch along the first edge of more than two triangles; empty if it is one.
std::string partsThere(const Repaired& repaired, std::span<const ModelPart> parts,
                       std::span<const std::uint32_t> partOfTriangle) {
  if (partOfTriangle.empty()) return {};
  std::vector<std::uint32_t> there;
  for (const std::uint32_t t : repaired.defects.nonManifoldTriangles) there.push_back(partOfTriangle[t]);
  std::sort(there.begin(), there.end());
  there.erase(std::unique(there.begin(), there.end()), there.end());
  if (there.size() < 2) return {};
  return fmt::format("; parts {} (\"{}\") and {} (\"{}\") touch there", there[0] + 1, parts[there[0]].name,
                     there[1] + 1, parts[there[1]].name);
}

void reportDefects(const Repaired& repaired, std::span<const ModelPart> parts,
                   std::span<const std::uint32_t> partOfTriangle, FindingList& findings) {
  const Defects& defects = repaired.defects;
  if (defects.openEdges > 0)
    findings.block(
        "open-edges", defects.openEdges,
        fmt::format("The surface is not closed: {} around {}, one at {}, of {}",
                    counted(defects.openEdges, "open edge", "open edges"),
                    counted(defects.holes, "hole or gap", "holes or gaps"), findings.place(defects.openAt),
                    facetsOf(repaired, std::span(&defects.openTriangle, 1))),
        "Close the holes and merge nearby vertices in a mesh program (\"make solid\", \"repair\"), then try again");
  if (defects.nonManifoldEdges > 0)
    findings.block(
        "non-manifold-edges", defects.nonManifoldEdges,
        counted(defects.nonManifoldEdges, "edge belongs", "edges belong") +
            fmt::format(" to more than two triangles, one at {}, of {}{}", findings.place(defects.nonManifoldEdgeAt),
                        facetsOf(repaired, defects.nonManifoldTriangles), partsThere(repaired, parts, partOfTriangle)),
        "Remove inner walls and doubled faces in a mesh program (\"make manifold\"), then try again");
  if (defects.nonManifoldVertices > 0)
    findings.warn("non-manifold-vertices", defects.nonManifoldVertices,
                  fmt::format("At {} parts of the surface touch in a single point, as at {}; left as it is",
                              counted(defects.nonManifoldVertices, "vertex", "vertices"),
                              findings.place(defects.nonManifoldVertexAt)),
                  "Slicers print it; strict checkers will call the result not manifold there");
}

void reportOrientation(const Repaired& repaired, bool allowed, FindingList& findings) {
  const Mesh& mesh = repaired.mesh;
  const Consistency& consistency = repaired.consistency;
  const Outwardness& outwardness = repaired.outwardness;
  const auto place = [&](std::uint32_t t) { return findings.place(mesh.corner(t, 0)); };
  if (consistency.oneSided)
    findings.block("one-sided", 1,
                   fmt::format("The surface has only one side, like a Moebius strip; one of its triangles is at {}",
                               place(*consistency.oneSided)),
                   "Rebuild that part in a mesh program; it bounds no volume");
  if (consistency.turned > 0)
    reportMended(allowed, "misoriented-triangles", consistency.turned,
                 counted(consistency.turned, "triangle faces", "triangles face") +
                     fmt::format(" the other way than the neighbours, one at {}", place(*consistency.turnedExample)),
                 "turned round", findings);
  if (outwardness.insideOut > 0)
    reportMended(allowed, "inside-out", outwardness.insideOut,
                 counted(outwardness.insideOut, "shell is", "shells are") +
                     fmt::format(" inside out, one at {}", place(*outwardness.insideOutExample)),
                 "turned round", findings);
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

std::string FindingList::place(Vec3 p) const {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x / scale_, p.y / scale_, p.z / scale_);
}

std::string FindingList::length(double mm) const {
  return scale_ == 1 ? fmt::format("{:.3g} mm", mm) : fmt::format("{:.3g} ({:.3g} mm)", mm / scale_, mm);
}

std::vector<Finding> FindingList::take() {
  std::stable_sort(findings_.begin(), findings_.end(),
                   [](const Finding& a, const Finding& b) { return a.severity > b.severity; });
  return std::move(findings_);
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

void reportRepairs(const Repaired& repaired, const RepairOptions& options, std::span<const ModelPart> parts,
                   std::span<const std::uint32_t> partOfTriangle, FindingList& findings) {
  reportFilling(repaired, findings);  // its reasons say more than the bare count of open edges
  reportDefects(repaired, parts, partOfTriangle, findings);
  reportOrientation(repaired, options.orient, findings);
  reportSeams(repaired, findings);
  reportCleaning(repaired.cleaning, options.dropStray, findings);
  reportUntangling(repaired.untangling, findings);
}

}  // namespace qrelief
