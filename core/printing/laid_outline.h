// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "printing/layer_grid.h"
#include "printing/print_process.h"

namespace qrelief {

/// The part of a layer's plane that is looked at.
struct LayerWindow {
  Vec2 origin{0};  ///< its lower left corner
  double stepMm = 0.1;
  int columns = 0, rows = 0;
};

/// How often each node of a window is enclosed by an outline: counted along the vertical line through the corner, then
/// along every row. Cost: O(nodes + segments · rows they pass).
/// @param outline  with the solid on the left, as CrossSections has it; all of it that is not left of or below the
/// corner
/// @param corner   a point left of and below the window, for which
/// @param winding  is how often it is enclosed
std::vector<std::int16_t> windingNumbers(std::span<const Segment2> outline, const LayerWindow& window, Vec2 corner,
                                         int winding);

/// What a printer leaves of a layer's cross-section, at half the layer's height.
///
/// No corner of the solid is sharper than the process can make it [morphological opening]: a nozzle lays an outer wall
/// along the line that is half a line's width within the outline, as wide all along. Where the solid is too thin for
/// that, a nozzle lays one line along its middle, no thinner than such lines can be, if it is long enough to be laid.
/// Then no corner of a gap is sharper than the process leaves it [closing].
///
/// Cost: O(nodes + segments · nodes near one).
/// @param outline, corner, winding  see windingNumbers()
/// @returns distances exact up to `kLaidReachMm` from the plastic, and no less beyond; within it exact beside the
/// outline,
///          and at least the pocket's radius below 0 farther in
LayerGrid layOutline(std::span<const Segment2> outline, const LayerWindow& window, Vec2 corner, int winding,
                     const PrintProcess& process);

inline constexpr double kLaidReachMm = 0.15;

}  // namespace qrelief
