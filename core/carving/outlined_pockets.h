// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "carving/outline.h"
#include "label/label_layout.h"
#include "projection/plane_shapes.h"

namespace qrelief {

/// Pockets of one depth with outlines of their own, such as letters, clear of all carved submodules.
struct OutlinedPockets {
  std::vector<Ring> rings;         ///< plane coordinates, mm; the pocket on their left; none cross
  std::vector<Rectangle> covered;  ///< rectangles that together cover all pockets, mm
  double depthMm = 0;              ///< > 0

  bool empty() const { return rings.empty(); }
};

/// Returns true if a triangle comes within `marginMm` of one of the covered rectangles.
/// @param triangle  counter-clockwise
bool touches(const Triangle2& triangle, const OutlinedPockets& pockets, double marginMm);

/// Adds the rings to a graph: a node at every corner, and more along sides that are longer than `longestMm`. A node may
/// move by an eighth of its shorter side, so that no ring crosses itself.
void addOutlines(OutlineGraph& graph, const OutlinedPockets& pockets, double longestMm);

/// Returns true if a counter-clockwise triangle and the box [low, high] share a point: no edge of either separates
/// them.
bool overlaps(const Triangle2& triangle, Vec2 low, Vec2 high);

}  // namespace qrelief
