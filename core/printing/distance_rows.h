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

}  // namespace qrelief
