// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace qrelief {

/// Grid nodes near a segment, and the segment: it begins at (x, y), where (0, 0) is the first node, and spans (alongX,
/// alongY).
struct SegmentRows {
  float* held = nullptr;   ///< squared distances in the first row, mm²
  std::size_t stride = 0;  ///< from one row to the next
  int columns = 0, rows = 0;
  float step = 0.1f;  ///< between nodes, mm
  float x = 0, y = 0, alongX = 0, alongY = 0;
};

/// Lowers each squared distance to the squared distance from the segment where that is smaller.
void lowerRows(const SegmentRows& rows);

/// Replaces squared distances by signed distances minus `lessMm`.
/// @param held      squared distances, mm²; afterwards signed distances, mm
/// @param inside    `count` values; the distance is negative where the value is below `lessThan`
void signedDistances(float* held, const float* inside, float lessThan, float lessMm, std::size_t count);

/// Finds the next cell between two rows of nodes that the contour of a value may cross. Cell k has the nodes k and k +
/// 1 of both rows.
/// @param columns  number of cells
/// @returns the first cell, at or after `column`, of a block of up to 8 cells that contains a crossing; `columns` if
///          none is left. A block of up to 7 cells at the end may be returned without a crossing
int nextCrossed(const float* lower, const float* upper, float value, int column, int columns);

/// Returns true if any wall is too thin for an outer line: a node where `laid` is above 0 and `solid` at most
/// `deepest`.
bool anyThin(const float* extruded, const float* solid, float deepest, std::size_t count);

}  // namespace qrelief
