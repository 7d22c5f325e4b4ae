// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "depth/depth_field.h"
#include "math/tolerance.h"
#include "math/vec.h"

namespace qrelief {

/// A depth field in whole quanta, so that depths compare as integers. Level 0 = not carved.
struct DepthLevels {
  int size = 0;  ///< submodules along an edge
  double symbolMm = 0;
  std::vector<int> level;  ///< row-major like DepthField::depthMm

  /// Returns the level of a submodule; 0 beyond the symbol's edge.
  int at(int row, int column) const {
    if (row < 0 || column < 0 || row >= size || column >= size) return 0;
    return level[row * size + column];
  }
  double submoduleMm() const { return symbolMm / size; }
  Vec2 corner(int row, int column) const {
    return {-symbolMm / 2 + column * submoduleMm(), symbolMm / 2 - row * submoduleMm()};
  }
};

inline double depthOfLevel(int level) { return level * kDepthQuantumMm; }

/// A straight stretch of a pocket's outline on the QR plane, from node to node.
struct Outline {
  std::uint32_t from = 0, to = 0;
  int left = 0, right = 0;  ///< depth levels on its two sides; different unless it bounds a resampled square
  bool leftResampled = false, rightResampled = false;  ///< true where a grid replaces the model's facets

  bool meetsModel() const { return !leftResampled || !rightResampled; }
  bool boundsGrid() const { return leftResampled != rightResampled; }
};

struct OutlineGraph {
  std::vector<Vec2> nodes;       ///< plane coordinates, mm
  std::vector<double> leewayMm;  ///< how far each node may move without making outlines touch; 0 = not at all
  std::vector<Outline> outlines;
};

/// Builds the planar graph of the lines along which neighbouring submodules differ in depth.
///
/// There is a node at every grid corner where outlines turn, branch or change depths. A corner that one outline passes
/// straight through is not a node, so uniform areas stay coarse. Four depths lie around a corner, clockwise from NW:
///
///          NW | NE        Walls run along the corner's ray. At depth x the ray belongs to one wall for each change
///         ----+----       between a cell shallower and a cell deeper than x in the cyclic sequence NW, NE, SE, SW.
///          SW | SE        The sequence changes 0, 2 or 4 times.
///
/// It changes four times only if one diagonal pair is wholly deeper than the other (a *saddle*). Four walls would then
/// share an edge, which is not allowed in a solid. The corner becomes two nodes, each moved along the diagonal into its
/// deeper cell, and the shallow cells join between them through a band as wide as the nodes are apart:
///
///          deep | shallow            deep  | shallow         Three cells meet at each of the two nodes. A cyclic
///         ------+------       →     -----A |                 sequence of three changes 0 or 2 times, so every
///        shallow| deep                    \|B----            stretch of every ray has at most two walls. A–B itself
///                                  shallow |  deep           is an outline if the shallow cells differ.
///
/// So every edge along a ray has exactly two walls. A node's vertex at depth L is then regular, too. Its link consists
/// of arcs across the floors at L and across the adjacent walls; the arcs meet in the two wall-to-wall edges above and
/// below. These have degree 0 or 2, and the walls reach both from the same floors, so the link is one closed curve.
///
/// @param chamferMm   distance between the two nodes of a saddle, less than submoduleMm / 2
/// @param maxCells    longest outline in submodules, ≥ 1; longer ones get nodes in between
OutlineGraph buildOutlines(const DepthLevels& levels, double chamferMm, int maxCells);

/// Builds the same graph for a square whose surface is resampled [Papp 2022, §5]. Every grid corner is a node, and
/// outlines run all round the square's border, carved or not. Only nodes on the border may move, as only the border
/// meets the model's own facets.
OutlineGraph buildGridOutlines(const DepthLevels& levels, double chamferMm);

}  // namespace qrelief
