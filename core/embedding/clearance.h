// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "embedding/edge_grid.h"
#include "embedding/outline.h"

namespace qrelief {

/// Keeps outlines clear of the model: moves the nodes of an outline graph a little, so that no model vertex or edge
/// comes so near to an outline that rounding to 32-bit floats could collapse or flip a triangle of the arrangement.
/// The model's own vertices stay.
///
/// A node stays where it is if all is clear there; else the best of a few places around it is taken (dart throwing
/// with fixed pseudo-random offsets), one node after another against those already placed, then once more against all.
/// That moves it by at most `snapMm`; who asks for another place again and again gets darts that fly twice as far each
/// time, up to the node's leeway: for the odd place where many edges meet in one point.
class Clearance {
 public:
  /// @param edges  the model's edges on the QR plane; outlives this object
  Clearance(OutlineGraph& graph, EdgeGrid& edges, double snapMm);

  /// Places all nodes. Cost: a grid query for each outline, more for the few that need moving.
  void placeAll();

  /// Throws other darts for these nodes, everything else fixed.
  void placeAgain(std::span<const std::uint32_t> nodes);

  /// Smallest of: distance from node to model edge, from model vertex to outline, and from a crossing of outline and
  /// model edge to the next model edge that the outline crosses, mm; at most `plentyMm()`, which nobody needs more
  /// than.
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
