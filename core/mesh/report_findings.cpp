// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/report_findings.h"

#include <algorithm>

#include "message_codes/model.h"

namespace qrelief {
namespace {

/// Returns the outcome of a repair, to be quoted within a finding.
Message done(bool allowed, Message repair) { return allowed ? std::move(repair) : message<"repair-switched-off">(); }

Message droppedOrMerged(const Cleaning& cleaning) {
  if (cleaning.mended == 0) return message<"repair-dropped">();
  return message<"repair-merged">(with::count<"merged">(cleaning.mended));
}

void reportCleaning(const Cleaning& cleaning, bool allowed, FindingList& findings) {
  if (cleaning.degenerate > 0)
    findings.mended(allowed,
                    message<"degenerate-triangles">(with::count<"count">(cleaning.degenerate),
                                                    with::place<"at">(findings.inFile(*cleaning.degenerateAt)),
                                                    with::cause<"done">(done(allowed, droppedOrMerged(cleaning)))));
  if (cleaning.duplicates > 0)
    findings.mended(allowed,
                    message<"duplicate-triangles">(with::count<"count">(cleaning.duplicates),
                                                   with::place<"at">(findings.inFile(*cleaning.duplicateAt)),
                                                   with::cause<"done">(done(allowed, message<"repair-dropped">()))));
}

void reportSeams(const Repaired& repaired, FindingList& findings) {
  if (const NearWelding& welding = repaired.welding; welding.moved > 0)
    findings.warn(message<"welded-vertices">(
        with::count<"count">(welding.moved), with::place<"at">(findings.inFile(welding.at)),
        with::lengthMm<"tolerance">(repaired.toleranceMm), with::lengthMm<"move">(welding.largestMoveMm)));
  if (const TJunctionSplit& split = repaired.split; split.vertices > 0)
    findings.warn(message<"t-junctions">(with::count<"count">(split.vertices),
                                         with::place<"at">(findings.inFile(split.at)),
                                         with::lengthMm<"gap">(split.largestGapMm)));
  if (repaired.seamsCutShort) findings.warn(message<"seams-too-crowded">());
}

void reportFilling(const Repaired& repaired, FindingList& findings) {
  const HoleFilling& filling = repaired.filling;
  if (filling.filled > 0)
    findings.warn(message<"holes-filled">(
        with::count<"count">(filling.filled), with::place<"at">(findings.inFile(filling.filledAt)),
        with::count<"triangles">(filling.beside.size()), with::lengthMm<"across">(filling.largestFilledMm)));
  if (filling.tooLarge > 0)
    findings.block(message<"large-openings">(
        with::count<"count">(filling.tooLarge), with::place<"at">(findings.inFile(filling.leftAt)),
        with::lengthMm<"most">(repaired.maxHoleMm), with::count<"mostEdges">(kMaxHoleEdges),
        with::lengthMm<"across">(filling.largestLeftMm), with::count<"edges">(filling.largestLeftEdges)));
  if (filling.blocked > 0)
    findings.block(message<"holes-left">(with::count<"count">(filling.blocked),
                                         with::place<"at">(findings.inFile(filling.blockedAt))));
}

/// Returns the facets' indices in the file.
std::vector<double> facetsOf(const Repaired& repaired, std::span<const std::uint32_t> triangles) {
  std::vector<double> facets;
  for (const std::uint32_t t : triangles) facets.push_back(repaired.origin[t] + 1.0);
  std::sort(facets.begin(), facets.end());
  facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  return facets;
}

void reportDefects(const Repaired& repaired, FindingList& findings) {
  const Defects& defects = repaired.defects;
  if (defects.openEdges > 0)
    findings.block(message<"open-edges">(
        with::count<"count">(defects.openEdges), with::place<"at">(findings.inFile(defects.openAt)),
        with::count<"holes">(defects.holes), with::index<"facet">(repaired.origin[defects.openTriangle] + 1)));
  if (defects.nonManifoldEdges > 0)
    findings.block(message<"non-manifold-edges">(
        with::count<"count">(defects.nonManifoldEdges), with::place<"at">(findings.inFile(defects.nonManifoldEdgeAt)),
        with::indices<"facets">(facetsOf(repaired, defects.nonManifoldTriangles))));
  if (defects.nonManifoldVertices > 0)
    findings.warn(message<"non-manifold-vertices">(with::count<"count">(defects.nonManifoldVertices),
                                                   with::place<"at">(findings.inFile(defects.nonManifoldVertexAt))));
}

void reportOrientation(const Repaired& repaired, bool allowed, FindingList& findings) {
  const Mesh& mesh = repaired.mesh;
  const Consistency& consistency = repaired.consistency;
  const Outwardness& outwardness = repaired.outwardness;
  const auto placeOf = [&](std::uint32_t t) { return findings.inFile(mesh.corner(t, 0)); };
  if (consistency.oneSided) findings.block(message<"one-sided">(with::place<"at">(placeOf(*consistency.oneSided))));
  if (consistency.turned > 0)
    findings.mended(allowed,
                    message<"misoriented-triangles">(with::count<"count">(consistency.turned),
                                                     with::place<"at">(placeOf(*consistency.turnedExample)),
                                                     with::cause<"done">(done(allowed, message<"repair-turned">()))));
  if (outwardness.insideOut > 0)
    findings.mended(allowed, message<"inside-out">(with::count<"count">(outwardness.insideOut),
                                                   with::place<"at">(placeOf(*outwardness.insideOutExample)),
                                                   with::cause<"done">(done(allowed, message<"repair-turned">()))));
  if (outwardness.nestedSolids > 0)
    findings.warn(message<"nested-solids">(with::count<"count">(outwardness.nestedSolids),
                                           with::place<"at">(placeOf(*outwardness.nestedExample))));
  if (outwardness.cavities > 0)
    findings.note(message<"cavities">(with::count<"count">(outwardness.cavities),
                                      with::place<"at">(placeOf(*outwardness.cavityExample))));
  if (!outwardness.nestingKnown)
    findings.note(message<"nesting-not-found">(with::count<"count">(consistency.shells.count)));
  if (consistency.shells.count > 1)
    findings.note(message<"several-shells">(with::count<"count">(consistency.shells.count)));
}

Message crossingPairs(const Untangling& untangling) {
  if (untangling.atLeast) return message<"crossing-pairs-at-least">(with::count<"count">(untangling.pairs));
  return message<"crossing-pairs">(with::count<"count">(untangling.pairs));
}

/// Reports crossing triangles. They do not block: carving elsewhere works.
void reportUntangling(const Untangling& untangling, FindingList& findings) {
  if (untangling.tooCrowded) findings.warn(message<"crossings-too-crowded">());
  if (untangling.pairs == 0) return;
  if (untangling.mended)
    findings.warn(message<"self-intersections-mended">(
        with::count<"count">(untangling.pairs), with::place<"at">(findings.inFile(untangling.at)),
        with::count<"moved">(untangling.moved), with::lengthMm<"move">(untangling.largestMoveMm)));
  else
    findings.warn(message<"self-intersections">(with::cause<"pairs">(crossingPairs(untangling)),
                                                with::place<"at">(findings.inFile(untangling.at))));
}

Message overlappingPairs(const Overlaps& overlaps) {
  if (overlaps.atLeast) return message<"overlapping-pairs-at-least">(with::count<"count">(overlaps.pairs));
  return message<"overlapping-pairs">(with::count<"count">(overlaps.pairs));
}

/// Reports shells that overlap or touch. Slicers take them for one solid, but a code keeps away from their crossings.
void reportOverlaps(const Repaired& repaired, FindingList& findings) {
  const Overlaps& overlaps = repaired.overlaps;
  if (overlaps.tooCrowded && !repaired.untangling.tooCrowded) findings.warn(message<"crossings-too-crowded">());
  if (overlaps.pairs > 0)
    findings.note(message<"overlapping-shells">(with::cause<"pairs">(overlappingPairs(overlaps)),
                                                with::place<"at">(findings.inFile(overlaps.at))));
}

}  // namespace

std::vector<Finding> FindingList::take() {
  std::stable_sort(findings_.begin(), findings_.end(),
                   [](const Finding& a, const Finding& b) { return a.severity > b.severity; });
  return std::move(findings_);
}

void reportRepairs(const Repaired& repaired, const RepairOptions& options, FindingList& findings) {
  reportFilling(repaired, findings);  // its reasons are more helpful than a bare count of open edges
  reportDefects(repaired, findings);
  reportOrientation(repaired, options.orient, findings);
  reportSeams(repaired, findings);
  reportCleaning(repaired.cleaning, options.dropStray, findings);
  reportUntangling(repaired.untangling, findings);
  reportOverlaps(repaired, findings);
}

}  // namespace qrelief
