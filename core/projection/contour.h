// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/frame.h"
#include "mesh/topology.h"
#include "projection/plane_shapes.h"

namespace qrelief {

/// How a facet lies to the eye. Edge-on counts as Away.
enum class Facing : std::uint8_t {
  Away,
  Front,            ///< towards the eye, and all its corners can be projected
  FrontOutOfReach,  ///< towards the eye, but a corner lies beside or behind the eye
};

/// A mesh as seen from the eye of a frame, before anything is known of hiding.
struct EyeView {
  std::vector<Vec2> projected;        ///< per vertex, on the QR plane, mm; (0, 0) where it cannot be projected
  std::vector<std::uint8_t> inFront;  ///< per vertex: 1 if it can be projected
  std::vector<Facing> facing;         ///< per triangle, exact
  double noiseMm = 0;                 ///< projected points nearer to one another than this cannot be told apart

  Triangle2 triangle(const Triangle& corners) const {
    return {projected[corners[0]], projected[corners[1]], projected[corners[2]]};
  }
};

/// Cost: one projection a vertex, one orientation test a facet.
EyeView viewFrom(const Mesh& mesh, const ProjectionFrame& frame);

inline constexpr std::uint32_t kNoVertex = 0xffffffffu;

/// An edge across which a sheet of the surface ends or turns away from the eye: between a facet that faces the eye and
/// one that does not, or an edge without a neighbour. Only across the projections of these can what is hidden change.
struct ContourEdge {
  std::array<Vec3, 2> ends;               ///< in front of the eye: cut off where the edge passes beside it
  std::array<std::uint32_t, 2> vertices;  ///< kNoVertex at an end that was cut off
  Segment2 projected;                     ///< on the QR plane, mm
};

/// All contour edges in front of the eye, ordered by triangle. Cost: O(T).
std::vector<ContourEdge> contourEdges(const Mesh& mesh, const Adjacency& adjacency, const ProjectionFrame& frame,
                                      const EyeView& view);

}  // namespace qrelief
