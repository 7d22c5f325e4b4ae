// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/footprint.h"

#include <algorithm>
#include <cmath>

#include "carving/needle.h"
#include "mesh/topology.h"
#include "message_codes/place.h"

namespace qrelief {
namespace {

bool touchesCarving(const Triangle2& t, const DepthLevels& levels, double marginMm) {
  const double h = levels.submoduleMm();
  const Vec2 origin = levels.corner(0, 0);
  const Vec2 lo = glm::min(glm::min(t[0], t[1]), t[2]) - marginMm;
  const Vec2 hi = glm::max(glm::max(t[0], t[1]), t[2]) + marginMm;
  const auto cell = [&](double mm) {
    return static_cast<int>(std::clamp(std::floor(mm / h), -1.0, levels.size + 0.0));
  };
  const int firstColumn = std::max(0, cell(lo.x - origin.x));
  const int lastColumn = std::min(levels.size - 1, cell(hi.x - origin.x));
  const int firstRow = std::max(0, cell(origin.y - hi.y));
  const int lastRow = std::min(levels.size - 1, cell(origin.y - lo.y));
  for (int row = firstRow; row <= lastRow; ++row)
    for (int column = firstColumn; column <= lastColumn; ++column) {
      if (levels.at(row, column) == 0) continue;
      const Vec2 topLeft = levels.corner(row, column);
      if (overlaps(t, topLeft + Vec2(-marginMm, -h - marginMm), topLeft + Vec2(h + marginMm, marginMm))) return true;
    }
  return false;
}

void addVertices(Footprint& footprint, const Mesh& mesh, const ProjectionFrame& frame) {
  std::vector<std::uint32_t> local(mesh.positions.size(), kNoFacet);
  for (const std::uint32_t facet : footprint.facets)
    for (const std::uint32_t v : mesh.triangles[facet]) local[v] = 0;
  for (std::uint32_t v = 0; v < local.size(); ++v) {
    if (local[v] == kNoFacet) continue;
    local[v] = static_cast<std::uint32_t>(footprint.vertices.size());
    footprint.vertices.push_back(v);
    footprint.points.push_back(frame.project(Vec3(mesh.positions[v])));
  }
  for (const std::uint32_t facet : footprint.facets) {
    const Triangle& t = mesh.triangles[facet];
    footprint.corners.push_back({local[t[0]], local[t[1]], local[t[2]]});
  }
}

void addEdges(Footprint& footprint) {
  const Adjacency adjacency = buildAdjacency(footprint.corners);
  for (std::uint32_t f = 0; f < adjacency.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = adjacency[f][k] == kNoTriangle ? kNoFacet : adjacency[f][k];
      if (other != kNoFacet && other < f) continue;  // already added from the other side
      footprint.edges.push_back({footprint.corners[f][k], footprint.corners[f][(k + 1) % 3], f, other});
    }
}

}  // namespace

Result<Footprint> findFootprint(const Mesh& mesh, const ProjectionFrame& frame, std::span<const std::uint32_t> patch,
                                const DepthLevels& levels, double marginMm, const OutlinedPockets& label) {
  Footprint footprint;
  const auto isTouched = [&](const Triangle2& t) {
    return touchesCarving(t, levels, marginMm) || touches(t, label, marginMm);
  };
  for (const std::uint32_t facet : patch) {
    Triangle2 t;
    bool inFront = true;
    for (int k = 0; k < 3; ++k) {
      const Vec3 corner = mesh.corner(facet, k);
      inFront = inFront && frame.distanceAlongAxis(corner) > 0;
      t[k] = frame.project(corner);
    }
    if (inFront && cross2(t[1] - t[0], t[2] - t[0]) > 0) {
      if (isTouched(t)) footprint.facets.push_back(facet);
    } else if (inFront && isTouched({t[0], t[2], t[1]})) {
      return fail(ErrorKind::NoSolution,
                  message<"facet-from-behind">(with::index<"facet">(facet), with::lengthMm<"right">(t[0].x),
                                               with::lengthMm<"up">(t[0].y)));
    }
  }
  std::sort(footprint.facets.begin(), footprint.facets.end());
  addVertices(footprint, mesh, frame);
  flipNeedles(footprint, mesh);
  addEdges(footprint);
  return footprint;
}

}  // namespace qrelief
