// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "carving/edge_grid.h"
#include "carving/footprint.h"
#include "carving/outline.h"

namespace qrelief {

/// Facets and outlines overlaid on the QR plane and triangulated. Every triangle has one depth and lies in one facet or
/// in the resampled square.
struct Arrangement {
  static constexpr std::uint32_t kGridFacet = 0xfffffffeu;

  /// A crossing of an outline and a model edge.
  struct Crossing {
    std::uint32_t edge = 0;     ///< index among the footprint's edges
    std::uint32_t outline = 0;  ///< index among the graph's outlines
    double alongEdge = 0;       ///< 0 at Edge::a … 1 at Edge::b, on the plane
    double alongOutline = 0;    ///< 0 at Outline::from … 1 at Outline::to
  };
  /// A piece of an outline between two consecutive vertices on it; a wall runs along it.
  struct Piece {
    std::uint32_t from = 0, to = 0;
    int left = 0, right = 0;
  };

  std::vector<Vec2> points;  ///< the footprint's vertices, then the graph's nodes, then the crossings
  std::uint32_t firstNode = 0, firstCrossing = 0;
  std::vector<Crossing> crossings;
  std::vector<Piece> pieces;
  std::vector<Triangle> triangles;    ///< only inside the footprint, counter-clockwise
  std::vector<std::uint32_t> facets;  ///< triangle → footprint facet; kGridFacet in a resampled square
  std::vector<int> levels;            ///< triangle → depth level
};

/// Overlays the footprint's edges and the outlines. Each crossing is computed once and shared by both lines. The pieces
/// between crossings constrain a Delaunay triangulation. The facets and levels on both sides of each piece are known
/// and spread from there over the triangles. If the graph bounds a resampled square, the model's edges end at the
/// square's border, and the graph's nodes replace the model's vertices inside.
///
/// Cost: O(n log n) in vertices and crossings.
/// @param edges  the footprint's edges, in the same order
/// @returns NoSolution if an outline, a carved area or the resampled square leaves the footprint; Internal if pieces
///          cross. The outlines' clearance from the model prevents crossings unless the footprint overlaps itself
Result<Arrangement> arrange(const Footprint& footprint, EdgeGrid& edges, const OutlineGraph& graph);

}  // namespace qrelief
