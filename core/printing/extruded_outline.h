// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "printing/layer_grid.h"
#include "printing/print_process.h"

namespace qrelief {

/// The rectangle of a layer's plane to compute.
struct LayerWindow {
  Vec2 origin{0};  ///< its lower left corner
  double stepMm = 0.1;
  int columns = 0, rows = 0;
};

/// Computes the winding number of an outline at each node of a window: along the vertical line through the corner, then
/// along every row. Cost: O(nodes + segments · rows they pass).
/// @param outline  with the solid on the left, as in CrossSections; must include all segments except those left of or
///                 below the corner
/// @param corner   a point left of and below the window
/// @param winding  winding number at the corner
std::vector<std::int16_t> windingNumbers(std::span<const Segment2> outline, const LayerWindow& window, Vec2 corner,
                                         int winding);

/// Computes the shape that a printer gives a layer's cross-section, at half the layer's height.
///
/// No corner of the solid is sharper than the process can make it [morphological opening]: a nozzle lays an outer wall
/// along the line half a line's width inside the outline, with constant width. Where the solid is too thin for that, a
/// nozzle lays a single line along its middle, at least as wide as the process needs, if the line is long enough.
/// Finally, no corner of a gap is sharper than the process leaves it [closing].
///
/// Cost: O(nodes + segments · nodes near one).
/// @param outline, corner, winding  see windingNumbers()
/// @returns signed distances. Outside the plastic they are exact up to `kExtrudedReachMm`, and at least that beyond.
///          Inside they are exact near the outline, and farther in they are at most minus the pocket's
///          radius
LayerGrid layOutline(std::span<const Segment2> outline, const LayerWindow& window, Vec2 corner, int winding,
                     const PrintProcess& process);

inline constexpr double kExtrudedReachMm = 0.15;

}  // namespace qrelief
