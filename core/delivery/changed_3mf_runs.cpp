// SPDX-License-Identifier: GPL-3.0-or-later
#include "delivery/changed_3mf_runs.h"

#include <algorithm>
#include <cmath>

#include "delivery/carved_objects.h"
#include "pipeline/engrave.h"

namespace qrelief {
namespace {

bool isUnderCode(const Placement& place, Vec3 point) {
  if (place.frame.distanceAlongAxis(point) <= 0) return false;
  const Vec2 p = place.frame.project(point);
  return std::max(std::abs(p.x), std::abs(p.y)) <= place.symbolMm / 2;
}

/// Returns the attributes that each facet keeps: none under the code.
std::vector<KeptAttributes> keptAttributes(const PreparedModel& before, const EngraveResult& result) {
  using What = KeptAttributes::What;
  using Kind = FacetOrigin::Kind;
  std::vector<char> isSeen(before.mesh.triangles.size(), 0);
  for (const std::uint32_t t : result.placement.patch.triangles) isSeen[t] = 1;
  std::vector<KeptAttributes> attributes(result.mesh.triangles.size());
  for (std::size_t t = 0; t < attributes.size(); ++t) {
    const FacetOrigin& origin = result.origins[t];
    if (origin.kind != Kind::Kept && origin.kind != Kind::Piece) continue;
    if (origin.facet == FacetOrigin::kNoFacet) continue;
    const Vec3 middle = (result.mesh.corner(t, 0) + result.mesh.corner(t, 1) + result.mesh.corner(t, 2)) / 3.0;
    if (isSeen[origin.facet] && isUnderCode(result.placement, middle)) continue;
    attributes[t] = {origin.kind == Kind::Kept ? What::All : What::WholePaint, before.originOfTriangle[origin.facet]};
  }
  return attributes;
}

}  // namespace

std::vector<ChangedRun> changed3mfRuns(const PreparedModel& before, const EngraveResult& result, bool withInlay) {
  const ThreeMfSource& source = *before.source;
  const std::vector<KeptAttributes> attributes = keptAttributes(before, result);
  std::vector<std::uint32_t> runs;
  for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) runs.push_back(result.mesh.body(t));
  std::vector<ChangedRun> changes;
  for (std::uint32_t r = 0; r < source.runs.size(); ++r) {
    if (r != result.carvedBody && !before.wasRepaired[r]) continue;
    ChangedRun change;
    change.run = r;
    const std::vector<std::uint32_t> triangles = trianglesOf(runs, r);
    change.mesh = submesh(result.mesh, triangles);
    for (const std::uint32_t t : triangles) change.kept.push_back(attributes[t]);
    change.painted = placesIn(triangles, result.painted);
    if (r == result.carvedBody && withInlay && result.inlay) change.inlay = codeBody(*result.inlay);
    changes.push_back(std::move(change));
  }
  return changes;
}

}  // namespace qrelief
