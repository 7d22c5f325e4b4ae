// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/spot_trial.h"

#include <algorithm>
#include <cmath>

#include "pipeline/spot_concerns.h"
#include "projection/flatness.h"

namespace qrelief {
namespace {

constexpr double kMostSlopeDeg = 70;         // steeper codes fitted but did not decode; the map's own limit is 65°
constexpr double kTrustedSizeShare = 1.001;  // least ratio of the largest size to the size offered
constexpr double kPerDirectionUnit = 1e4;

Vec3 roundedTo(Vec3 v, double perUnit) {
  return {std::round(v.x * perUnit) / perUnit, std::round(v.y * perUnit) / perUnit,
          std::round(v.z * perUnit) / perUnit};
}

}  // namespace

double wantedMm(const SpotSearchRequest& request) {
  const PlacementRequest& placement = request.placement;
  return placement.sizeMode == SizeMode::Fixed ? placement.sizeMm : placement.maxSizeMm;
}

SpotTrial::SpotTrial(const EngravableModel& model, const SpotSearchRequest& request, const SizeMap& map,
                     const SpotCandidate& candidate, bool findsLargest)
    : model_(&model), request_(&request), map_(&map), candidate_(candidate), findsLargest_(findsLargest) {}

void SpotTrial::beginTry() {
  PlacementRequest placement = request_->placement;
  centreFileUnits_ =
      roundedTo(candidate_.position / request_->scaleToMm, std::pow(10, centreDecimals(request_->scaleToMm)));
  placement.centreMm = centreFileUnits_ * request_->scaleToMm;
  if (withDirection_) placement.direction = roundedTo(candidate_.direction, kPerDirectionUnit);
  direction_ = placement.direction;
  const double pocketMm = placement.pockets.depth(wantedMm(*request_) / request_->modules);
  placement.beyondMm = std::max(placement.beyondMm, request_->minWallMm + std::max(request_->leastDepthMm, pocketMm));
  if (findsLargest_) placement.maxSizeMm = std::max(placement.maxSizeMm, wantedMm(*request_));
  if (findsLargest_) placement.sizeMode = SizeMode::Oriented;
  search_.emplace(model_->prepared, *model_->renderer, request_->modules, placement, PlacementSearch::Advice::None);
  ++tries_;
}

/// Tries the map's direction next. @returns true if it was tried already
bool SpotTrial::endTry() {
  search_.reset();
  if (withDirection_ || request_->placement.direction) return true;
  withDirection_ = true;
  return false;
}

/// @returns true if the spot is offered
Result<bool> SpotTrial::judge(const Placement& placement) {
  const double outer = request_->outerFactor();
  Spot spot;
  spot.centreFileUnits = centreFileUnits_;
  spot.centreMm = centreFileUnits_ * request_->scaleToMm;
  spot.body = model_->prepared.mesh.body(placement.seed);
  spot.direction = direction_.value_or(placement.frame.normal);
  spot.needsDirection = withDirection_;
  if (request_->coloured) spot.colourLayers = layersOfCode(placement, request_->modules, *request_->coloured);
  spot.symbolMm = placement.symbolMm;
  spot.guaranteedMm = placement.guaranteedMm;
  spot.aimToleranceDeg = aimToleranceDeg(placement.bendMm, placement.moduleMm);
  spot.largestMm = placement.largestMm;
  spot.quality = qualityOf(*map_, placement.frame, placement.symbolMm * outer);
  const bool isFixed = request_->placement.sizeMode == SizeMode::Fixed;
  const double limitMm = std::max(wantedMm(*request_), request_->placement.maxSizeMm);  // of largestMm
  const bool isTight =
      isFixed && !findsLargest_ && spot.largestMm < std::min(kTrustedSizeShare * spot.symbolMm, limitMm);
  if (isTight || spot.quality.worstAngleDeg > kMostSlopeDeg) return false;
  const auto concerns = concernsAt(*model_, placement, *request_);
  QRELIEF_TRY(concerns);
  if (!concerns->takesPockets && (!request_->offersThinWalls || findsLargest_)) {
    if (!withDirection_) thinWallMm_ = concerns->wallMm;
    return false;
  }
  spot.prints = concerns->prints;
  spot.takesPockets = concerns->takesPockets;
  spot.coversColours = concerns->coversColours;
  spot.facesDown = concerns->facesDown;
  spot.unevenLight = concerns->unevenLight;
  spot.concerns = concerns->reasons;
  spot.placement = std::make_shared<const Placement>(placement);
  spot_ = spot;
  return true;
}

Result<bool> SpotTrial::step() {
  if (!search_) beginTry();
  const Result<bool> placed = search_->step();
  if (!placed && placed.error().kind != ErrorKind::NoSolution) return placed;
  if (!placed) {
    meetsCrossings_ = meetsCrossings_ || search_->meetsCrossings();
    return endTry();
  }
  if (!*placed) return false;
  if (findsLargest_) meetsCrossings_ = meetsCrossings_ || search_->wouldMeetCrossings(wantedMm(*request_));
  const Result<bool> isOffered = judge(search_->placement());
  if (!isOffered || *isOffered) return isOffered;
  return endTry();
}

}  // namespace qrelief
