// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/optimal_direction.h"

#include <array>
#include <cmath>

#include "math/angle.h"

namespace qrelief {
namespace {

constexpr double kFirstStep = toRadians(8);
constexpr double kLastStep = toRadians(1);

}  // namespace

OptimalDirection::OptimalDirection(const SurfaceRenderer& surface, Vec3 centre, Vec3 start, Vec3 upHint,
                                   double eyeDistance, const DirectionOptions& options)
    : surface_(&surface),
      frame_(makeFrame(centre, start, upHint, eyeDistance)),
      upHint_(upHint),
      options_(options),
      stepAngle_(kFirstStep) {}

Vec3 OptimalDirection::turned(Vec2 turn) const {
  const double angle = glm::length(turn);
  if (angle == 0) return frame_.normal;
  const Vec3 towards = (frame_.right * turn.x + frame_.up * turn.y) / angle;
  return glm::normalize(frame_.normal * std::cos(angle) + towards * std::sin(angle));
}

/// Chooses the next side to try within the bound; returns false once the last step has been tried on all sides.
bool OptimalDirection::chooseNext() {
  constexpr std::array<Vec2, 4> kSides = {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)};
  for (;;) {
    if (tried_ == 4) {
      stepAngle_ /= 2;
      tried_ = 0;
      if (stepAngle_ < kLastStep * 0.99) return false;
    }
    next_ = bestTurn_ + kSides[(side_ + tried_) % 4] * stepAngle_;
    if (glm::length(next_) <= kFarthestTurn) return true;
    ++tried_;
  }
}

Result<bool> OptimalDirection::step() {
  const Vec3 normal = turned(next_);
  const ProjectionFrame frame = makeFrame(frame_.centre, normal, upHint_, frame_.eyeDistance);
  const Result<MapSample> looked = lookFrom(*surface_, frame, options_);
  QRELIEF_TRY(looked);
  iterations_.push_back({normal, looked->varianceMm2, looked->outsideFraction, looked->worstAngle, looked->measure});
  const bool isFirst = iterations_.size() == 1;
  if (!isFirst && looked->centreIsSeen && looked->measure < iterations_[best_].measure) {
    best_ = iterations_.size() - 1;
    bestTurn_ = next_;
    side_ = (side_ + tried_) % 4;
    tried_ = 0;
  } else if (!isFirst) {
    ++tried_;
  }
  return !chooseNext() || static_cast<int>(iterations_.size()) >= kMaxLooks;
}

}  // namespace qrelief
