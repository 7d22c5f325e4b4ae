// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "embedding/depth_levels.h"
#include "math/vec.h"

namespace qrelief {

/// A straight stretch of pocket outline on the QR plane, from node to node.
struct Outline {
  std::uint32_t from = 0, to = 0;
  int left = 0, right = 0;  ///< levels of depth on its two sides; they differ unless it bounds a resampled square
  bool leftResampled = false, rightResampled = false;  ///< sides on which a grid takes the place of the model's facets

  bool meetsModel() const { return !leftResampled || !rightResampled; }
  bool boundsGrid() const { return leftResampled != rightResampled; }
};

struct OutlineGraph {
  std::vector<Vec2> nodes;       ///< plane coordinates, mm
  std::vector<double> leewayMm;  ///< how far each node may move without outlines coming to touch; 0 = not at all
  std::vector<Outline> outlines;
};

/// The lines along which neighbouring submodules differ in depth, as a planar graph.
///
/// A node stands at every grid corner where outlines turn, branch or change depths; a corner that one outline passes
/// straight is no node, so uniform areas stay coarse. Around a corner lie four depths, north-west to south-west:
///
///          NW | NE        Walls stand along the corner's ray. The stretch of it at depth x belongs to the walls
///         ----+----       between a cell shallower and a cell deeper than x: as often as the cyclic sequence
///          SW | SE        NW, NE, SE, SW changes from one to the other, that is 0, 2 or 4 times.
///
/// Four times only if one diagonal pair is wholly deeper than the other (a *saddle*): four walls would share an edge,
/// which no solid may have. There the corner becomes two nodes, each moved along the diagonal into its deeper cell, and
/// the shallow cells join between them through a band as wide as the nodes are apart:
///
///          deep | shallow            deep  | shallow         At each of the two nodes three cells meet. A cyclic
///         ------+------       →     -----A |                 sequence of three changes 0 or 2 times: at most two
///        shallow| deep                    \|B----            walls on every stretch of every ray. A–B itself is an
///                                  shallow |  deep           outline if the shallow cells differ.
///
/// So every edge along a ray has exactly two walls. The vertex at depth L of a node is then regular as well: its link
/// consists of arcs across the floors at L and across the walls beside them, meeting in the two wall-to-wall edges
/// above and below; as those have degree 0 or 2 and the walls reach both from the same floors, it is one closed curve.
///
/// @param chamferMm   distance of the two nodes of a saddle, less than submoduleMm / 2
/// @param maxCells    longest outline in submodules, ≥ 1; longer ones get nodes in between
OutlineGraph buildOutlines(const DepthLevels& levels, double chamferMm, int maxCells);

/// The same for a square whose surface is resampled [Papp 2022, §5]: every grid corner is a node, and outlines run all
/// round the square's border, carved there or not. Only the border meets the model's own facets: its nodes alone may
/// move.
OutlineGraph buildGridOutlines(const DepthLevels& levels, double chamferMm);

}  // namespace qrelief
