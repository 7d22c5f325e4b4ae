// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "projection/direction.h"

namespace qrelief {

/// The direction whose `MapSample::measure` is least, by a bounded search on the sphere around a start (beyond the
/// paper: its future work), one rendering a step.
///
/// **Method.** Compass search [Hooke, Jeeves 1961; Kolda, Lewis, Torczon 2003]: from the best direction so far a step
/// in one of four perpendicular directions on the sphere, the last successful one first; where none is better, the step
/// is halved, from 8° down to 1°. It stays within kFarthestTurn of the start, and never looks from where something else
/// hides the centre. The start is the first candidate, so the answer is never worse than it.
///
/// Cost: at most kMaxLooks renderings; 17 if the start is the best.
class OptimalDirection {
 public:
  static constexpr double kFarthestTurn = 0.6;  ///< radians: 34°
  static constexpr int kMaxLooks = 40;

  /// @param pass, mesh  kept by reference
  /// @param start       any length > 0; DepthBalanced's answer
  /// @param options     the square and its sampling; the method does not matter
  OptimalDirection(const GeometryPass& pass, const GpuMesh& mesh, Vec3 centre, Vec3 start, Vec3 upHint,
                   double eyeDistance, const DirectionOptions& options);

  /// Looks from one more direction. @returns true when the search is over
  Result<bool> step();

  Vec3 normal() const { return iterations_[best_].normal; }
  /// All directions looked from, the start first.
  const std::vector<DirectionIteration>& iterations() const { return iterations_; }

 private:
  Vec3 turned(Vec2 turn) const;
  bool chooseNext();

  const GeometryPass* pass_;
  const GpuMesh* mesh_;
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
