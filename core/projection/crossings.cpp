// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/crossings.h"

#include <algorithm>
#include <array>

#include "mesh/crossing_segments.h"
#include "message_codes/place.h"

namespace qrelief {
namespace {

constexpr std::size_t kMaxPairs = 100'000;

/// Finds the segments that facets of the patch share with others, some of which may also belong to the patch.
/// @param known  see addCrossings()
Result<std::vector<Segment3>> crossingsOf(const Mesh& mesh, std::span<const std::uint32_t> triangles,
                                          const std::vector<TrianglePair>* known) {
  std::vector<TrianglePair> found;
  if (!known) {
    auto pairs = findCrossings(mesh, triangles, kMaxPairs);
    QRELIEF_TRY(pairs);
    if (pairs->size() >= kMaxPairs)
      return fail(ErrorKind::NoSolution, message<"too-many-crossings">(with::count<"most">(kMaxPairs)));
    found = std::move(*pairs);
  }
  std::vector<Segment3> segments;
  for (const auto& [s, t] : known ? *known : found) {
    for (const auto& [mine, other] : {std::array{s, t}, std::array{t, s}}) {
      if (!std::binary_search(triangles.begin(), triangles.end(), mine)) continue;
      for (const Segment3& segment : crossingSegments(mesh, mine, other)) segments.push_back(segment);
    }
  }
  return segments;
}

Vec3 nearestOn(const Segment3& segment, Vec3 place) {
  const Vec3 along = segment[1] - segment[0];
  const double squared = glm::dot(along, along);
  const double parameter = squared > 0 ? glm::dot(place - segment[0], along) / squared : 0;
  return segment[0] + std::clamp(parameter, 0.0, 1.0) * along;
}

}  // namespace

Status addCrossings(const Mesh& mesh, const ProjectionFrame& frame, VisiblePatch& patch,
                    const std::vector<TrianglePair>* known) {
  const auto segments = crossingsOf(mesh, patch.triangles, known);
  QRELIEF_TRY(segments);
  for (const auto& [from, to] : *segments) patch.silhouette.push_back({frame.project(from), frame.project(to)});
  return {};
}

Result<std::optional<Vec3>> nearestCrossing(const Mesh& mesh, std::span<const std::uint32_t> triangles, Vec3 place,
                                            const std::vector<TrianglePair>* known) {
  const auto segments = crossingsOf(mesh, triangles, known);
  QRELIEF_TRY(segments);
  std::optional<Vec3> nearest;
  for (const Segment3& segment : *segments) {
    const Vec3 point = nearestOn(segment, place);
    if (!nearest || glm::distance(point, place) < glm::distance(*nearest, place)) nearest = point;
  }
  return nearest;
}

}  // namespace qrelief
