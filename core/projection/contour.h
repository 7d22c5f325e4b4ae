// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "math/frame.h"
#include "mesh/topology.h"
#include "projection/plane_shapes.h"

namespace qrelief {

/// Orientation of a facet towards the eye. Edge-on counts as Away.
enum class Facing : std::uint8_t {
  Away,
  Front,            ///< faces the eye, and all its corners can be projected
  FrontOutOfReach,  ///< faces the eye, but a corner lies level with the eye or behind it
};

/// A mesh as seen from the eye of a frame, before hidden parts are determined.
struct EyeView {
  std::vector<Vec2> projected;        ///< per vertex, on the QR plane, mm; (0, 0) where it cannot be projected
  std::vector<std::uint8_t> inFront;  ///< per vertex: 1 if it can be projected
  std::vector<Facing> facing;         ///< per triangle, exact; Away where it was not looked at
  double noiseMm = 0;                 ///< projected points closer together than this count as equal

  Triangle2 triangle(const Triangle& corners) const {
    return {projected[corners[0]], projected[corners[1]], projected[corners[2]]};
  }
};

/// Projects facets of a mesh and classifies them. Cost: one projection and one orientation test per facet.
EyeView viewFrom(const Mesh& mesh, const ProjectionFrame& frame, std::span<const std::uint32_t> facets);

inline constexpr std::uint32_t kNoVertex = 0xffffffffu;

/// An edge at which a sheet of the surface ends or turns away from the eye: it has no neighbour, or lies between a
/// facet that faces the eye and one that does not. Visibility can change only across the projections of these edges.
struct ContourEdge {
  std::array<Vec3, 2> ends;               ///< in front of the eye; cut off where the edge passes the eye
  std::array<std::uint32_t, 2> vertices;  ///< kNoVertex at an end that was cut off
  Segment2 projected;                     ///< on the QR plane, mm
};

/// Finds the contour edges of facets in front of the eye, in the order of the facets.
/// @param view  has these facets and their neighbours
std::vector<ContourEdge> contourEdges(const Mesh& mesh, const Adjacency& adjacency, const ProjectionFrame& frame,
                                      const EyeView& view, std::span<const std::uint32_t> facets);

}  // namespace qrelief
