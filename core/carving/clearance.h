// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "carving/edge_grid.h"
#include "carving/outline.h"

namespace qrelief {

/// Keeps outlines clear of the model. Moves the nodes of an outline graph slightly, so that rounding to 32-bit floats
/// cannot collapse or flip a triangle of the arrangement between an outline and a nearby model vertex or edge. The
/// model's own vertices stay.
///
/// A node that is clear stays in place. Any other node takes the best of a few places around it (dart throwing with
/// fixed pseudo-random offsets). Nodes are placed one after another, each clear of the nodes placed before; a second
/// round clears each of all others. This moves a node by at most `snapMm`. Each further call of placeAgain() doubles
/// the range of the darts, up to the node's leeway; the rare places where many edges meet in one point need this.
class Clearance {
 public:
  /// @param edges  the model's edges on the QR plane; outlives this object
  Clearance(OutlineGraph& graph, EdgeGrid& edges, double snapMm);

  /// Places all nodes. Cost: a grid query for each outline, more for the few that need moving.
  void placeAll();

  /// Finds new places for these nodes, with all others fixed.
  void placeAgain(std::span<const std::uint32_t> nodes);

  /// Returns the smallest distance, mm, from a node to a model edge, from a model vertex to an outline, or from a
  /// crossing of an outline and a model edge to the next model edge that the outline crosses; at most plentyMm(), which
  /// is always enough.
  double smallest() const;
  double plentyMm() const { return plentyMm_; }

 private:
  struct Crossing {
    double along;
    std::uint32_t edge;
  };
  double outlineClearance(Vec2 p, Vec2 q, double enough) const;
  double nodeClearance(std::uint32_t node, Vec2 position, double enough) const;
  Vec2 dart(std::uint32_t node);
  void place(std::uint32_t node);

  OutlineGraph& graph_;
  EdgeGrid& edges_;
  const double snapMm_, plentyMm_;
  std::vector<Vec2> ideal_;
  std::vector<std::uint32_t> firstIncident_, incident_;  // node → outlines
  std::vector<char> placed_;
  std::vector<std::uint32_t> throws_;        // darts thrown so far at each node
  mutable std::vector<Crossing> crossings_;  // scratch
};

}  // namespace qrelief
