// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace qrelief {

/// Nodes of a grid near a segment, and the segment: from (x, y), where (0, 0) is the first node, by (alongX, alongY).
struct SegmentRows {
  float* held = nullptr;   ///< squared distances that the first row holds, mm²
  std::size_t stride = 0;  ///< from a row to the next
  int columns = 0, rows = 0;
  float step = 0.1f;  ///< between nodes, mm
  float x = 0, y = 0, alongX = 0, alongY = 0;
};

/// Lowers squared distances to those from the segment.
void lowerRows(const SegmentRows& rows);

/// Distances of squared ones, negative where `inside` is less than a value, and all lessened by another.
/// @param held    squared distances, mm²; afterwards distances, mm
/// @param inside  as many
void signedDistances(float* held, const float* inside, float lessThan, float lessMm, std::size_t count);

/// Whether a value lies between corners of a cell: column k between the nodes k and k + 1 of two rows.
/// @returns the first such column from `column` on that may be one, in blocks of up to 8; `columns` if there is none
int nextCrossed(const float* lower, const float* upper, float value, int column, int columns);

/// Whether an outer wall is missing somewhere: nodes at which `laid` is more than 0 and `solid` at most `deepest`.
bool anyThin(const float* laid, const float* solid, float deepest, std::size_t count);

}  // namespace qrelief
