// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/contour.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"
#include "math/orientation.h"
#include "math/tolerance.h"

namespace qrelief {
namespace {

constexpr std::size_t kFacetsAPiece = 1 << 14;  // of parallel work: some tenths of a millisecond

Facing facingOf(const Mesh& mesh, std::size_t triangle, Vec3 eye, const EyeView& view) {
  if (sideOfPlane(mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2), eye) <= 0)
    return Facing::Away;
  const Triangle& t = mesh.triangles[triangle];
  return view.inFront[t[0]] && view.inFront[t[1]] && view.inFront[t[2]] ? Facing::Front : Facing::FrontOutOfReach;
}

/// Returns the part of an edge in front of the eye; precondition: at least one end lies there.
ContourEdge contourEdge(const Mesh& mesh, std::uint32_t from, std::uint32_t to, const ProjectionFrame& frame,
                        const EyeView& view) {
  ContourEdge edge{{Vec3(mesh.positions[from]), Vec3(mesh.positions[to])}, {from, to}, {}};
  for (std::size_t k = 0; k < 2; ++k) {
    if (view.inFront[edge.vertices[k]]) {
      edge.projected[k] = view.projected[edge.vertices[k]];
      continue;
    }
    // Cut at twice the near plane, so that rounding cannot put the new end behind it.
    const Vec3 inside = edge.ends[1 - k];
    const double nearDepth = 2 * kNearPlaneFraction * frame.eyeDistance;
    const double insideDepth = frame.distanceAlongAxis(inside);
    const double outsideDepth = frame.distanceAlongAxis(edge.ends[k]);
    const double fraction = insideDepth > nearDepth ? (insideDepth - nearDepth) / (insideDepth - outsideDepth) : 0;
    edge.ends[k] = inside + (edge.ends[k] - inside) * fraction;
    edge.vertices[k] = kNoVertex;
    edge.projected[k] = frame.project(edge.ends[k]);
  }
  return edge;
}

}  // namespace

EyeView viewFrom(const Mesh& mesh, const ProjectionFrame& frame, std::span<const std::uint32_t> facets) {
  EyeView view;
  view.projected.resize(mesh.positions.size(), Vec2(0));
  view.inFront.resize(mesh.positions.size(), 0);
  view.facing.resize(mesh.triangles.size(), Facing::Away);
  const double nearDepth = kNearPlaneFraction * frame.eyeDistance;
  for (const std::uint32_t t : facets)
    for (const std::uint32_t v : mesh.triangles[t]) {
      const Vec3 p(mesh.positions[v]);
      if (view.inFront[v] || frame.distanceAlongAxis(p) <= nearDepth) continue;
      view.inFront[v] = 1;
      view.projected[v] = frame.project(p);
    }
  const Vec3 eye = frame.eye();
  view.noiseMm = kProjectionNoise * (glm::length(eye) + frame.eyeDistance);
  parallelForPieces(facets.size(), kFacetsAPiece,
                    [&](std::size_t i) { view.facing[facets[i]] = facingOf(mesh, facets[i], eye, view); });
  return view;
}

std::vector<ContourEdge> contourEdges(const Mesh& mesh, const Adjacency& adjacency, const ProjectionFrame& frame,
                                      const EyeView& view, std::span<const std::uint32_t> facets) {
  std::vector<ContourEdge> edges;
  for (const std::uint32_t t : facets) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t across = adjacency[t][k];
      const bool folds =
          across == kNoTriangle || (view.facing[t] != Facing::Away && view.facing[across] == Facing::Away);
      if (!folds) continue;
      const std::uint32_t from = mesh.triangles[t][k];
      const std::uint32_t to = mesh.triangles[t][(k + 1) % 3];
      if (view.inFront[from] || view.inFront[to]) edges.push_back(contourEdge(mesh, from, to, frame, view));
    }
  }
  return edges;
}

}  // namespace qrelief
