// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "projection/plane_shapes.h"

namespace qrelief {

/// A square about the origin of the QR plane.
struct TurnedSquare {
  double sizeMm = 0;    ///< its edge
  double rotation = 0;  ///< anticlockwise from the plane's axes, radians, -π/4 … π/4
};

/// The largest square about the origin, at any rotation, that the silhouette does not enter: the rotation for which
/// `orientedSize` is largest (what [Papp 2022, §9] leaves for the future). Of several such rotations the one least
/// turned.
///
/// **Method.** A growing square first meets a segment either with a side, at one of the segment's ends, or with a
/// corner. With t = tan(rotation), half its edge is then (x + y·t)/√(1 + t²) for an end whose coordinates, after some
/// quarter turns, are x and y, and √(1 + t²)/(a + b·t) for the line of a segment. Two such curves meet where a linear
/// or a quadratic equation in t holds. Their lower envelope, found by merging those of two halves, is half the size
/// that fits at each rotation. It is largest at a critical rotation: where two curves meet, or at the top of an end's
/// curve (the end lies in the middle of a side). Nothing is sampled.
///
/// Cost: O(n log n) for n segments nearer than √2 times the nearest; farther ones cannot bound the answer.
/// @param maxMm  upper bound of the size, > 0, finite
TurnedSquare bestSize(std::span<const Segment2> silhouette, double maxMm);

/// The same segments in axes turned anticlockwise by `rotation` (radians).
std::vector<Segment2> inTurnedAxes(std::span<const Segment2> segments, double rotation);

}  // namespace qrelief
