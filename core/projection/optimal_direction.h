// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "projection/direction.h"

namespace qrelief {

/// Search for the direction with the least `MapSample::measure` on the sphere around a start, within a bound (beyond
/// the paper: its future work), one rendering per step.
///
/// **Method.** Compass search [Hooke, Jeeves 1961; Kolda, Lewis, Torczon 2003]. From the best direction so far it takes
/// a step in one of four perpendicular directions on the sphere, the last successful one first. Where none is better it
/// halves the step, from 8° down to 1°. It stays within kFarthestTurn of the start, and rejects directions from which
/// something else hides the centre. The start is the first candidate, so the answer is never worse than the start.
///
/// Cost: at most kMaxLooks renderings; 17 if the start is the best.
class OptimalDirection {
 public:
  static constexpr double kFarthestTurn = 0.6;  ///< radians: 34°
  static constexpr int kMaxLooks = 40;

  /// @param surface  kept by reference
  /// @param start    any length > 0; DepthBalanced's answer
  /// @param options  the square and its sampling; the method is ignored
  OptimalDirection(const SurfaceRenderer& surface, Vec3 centre, Vec3 start, Vec3 upHint, double eyeDistance,
                   const DirectionOptions& options);

  /// Renders from one more direction. @returns true when the search is over
  Result<bool> step();

  Vec3 normal() const { return iterations_[best_].normal; }
  /// Returns all directions tried, the start first.
  const std::vector<DirectionIteration>& iterations() const { return iterations_; }

 private:
  Vec3 turned(Vec2 turn) const;
  bool chooseNext();

  const SurfaceRenderer* surface_;
  ProjectionFrame frame_;  // the start's
  Vec3 upHint_;
  DirectionOptions options_;
  double stepAngle_;
  int side_ = 0;      // of the four
  int tried_ = 0;     // sides since the last gain
  Vec2 next_{0};      // turn from the start towards the frame's right and up, radians
  Vec2 bestTurn_{0};  // the same
  std::size_t best_ = 0;
  std::vector<DirectionIteration> iterations_;
};

}  // namespace qrelief
