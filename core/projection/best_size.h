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

/// Finds the largest square about the origin, at any rotation, that the silhouette does not enter: the rotation that
/// maximises `orientedSize` (left for the future by [Papp 2022, §9]). Of several such rotations it returns the
/// smallest.
///
/// **Method.** A growing square first meets a segment in one of two ways: a side meets an end of the segment, or a
/// corner meets the line between the ends. With t = tan(rotation), half its edge is then (x + y·t)/√(1 + t²) for an end
/// whose coordinates, after some quarter turns, are x and y, and √(1 + t²)/(a + b·t) for the line of a segment. Two
/// such curves meet where a linear or a quadratic equation in t holds. Their lower envelope, found by merging the
/// envelopes of two halves, is half the size that fits at each rotation. Its maximum lies at a critical rotation: where
/// two curves meet, or at the top of an end's curve (the end then lies in the middle of a side). Nothing is sampled.
///
/// Cost: O(n log n) for the n segments within √2 times the distance of the nearest; farther ones cannot bound the
/// answer.
/// @param maxMm  upper bound of the size, > 0, finite
TurnedSquare bestSize(std::span<const Segment2> silhouette, double maxMm);

/// Returns the segments in axes turned anticlockwise by `rotation` (radians).
std::vector<Segment2> inTurnedAxes(std::span<const Segment2> segments, double rotation);

}  // namespace qrelief
