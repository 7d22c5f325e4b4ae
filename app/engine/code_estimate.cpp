// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/code_estimate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/angle.h"

namespace qrelief {
namespace {

constexpr double kFirstFraction = 0.15;  // of the model's diagonal: first size to sample, as in PlacementSearch
constexpr double kMuchSmaller = 0.6;     // a size below this fraction of the sampled size is sampled again
constexpr int kRounds = 2;
constexpr int kDirectionTexels = 48;
constexpr int kDirectionSamples = 256;
constexpr int kDirectionLooks = 3, kQuickDirectionLooks = 1;
constexpr int kReachTexels = 128;
constexpr double kReachMargin = 1.05;
constexpr double kAhead = 1.25;  // room for a code larger than expected
constexpr int kTurns = 18;       // rotations tried for the best one, over a quarter turn

/// @param mostLooks  limit on the looks for the direction
Result<Vec3> directionAt(const EstimatedSurface& surface, const SurfacePoint& centre, double sizeMm, int mostLooks,
                         const PlacementRequest& request) {
  if (request.direction) return *request.direction;
  DirectionOptions options;
  const bool isRefined =
      request.directionMethod == DirectionMethod::Optimal || request.directionMethod == DirectionMethod::Largest;
  options.method = isRefined ? DirectionMethod::DepthBalanced : request.directionMethod;
  options.sizeMm = sizeMm;
  options.samples = kDirectionSamples;
  options.mapTexels = kDirectionTexels;
  DirectionSearch search(surface.renderer, centre.position, triangleNormal(surface.mesh, centre.triangle),
                         request.upHint, request.eyeDistanceMm, options);
  for (int i = 0; i < mostLooks; ++i) {
    const Result<bool> isDone = search.step();
    QRELIEF_TRY(isDone);
    if (*isDone) break;
  }
  return search.normal();
}

/// Returns the turn that SizeMode::Best would take, in radians.
double bestTurn(const VisibilityMap& reach) {
  const double upright = reach.alignedMm(0);
  double best = 0, largest = upright;
  for (int i = 1; i < kTurns; ++i) {
    const double turn = toRadians(i * 90.0 / kTurns - (2 * i > kTurns ? 90 : 0));
    const double fits = reach.alignedMm(turn);
    if (fits <= largest) continue;
    largest = fits;
    best = turn;
  }
  return upright >= kUprightFraction * largest ? 0 : best;
}

/// @param room   edge of the largest symbol that fits in the map at every rotation, mm
/// @param looks  limit on the looks for each direction
Result<CodeEstimate> estimateWithin(double room, double sampled, int looks, const EstimatedSurface& surface,
                                    const SurfacePoint& centre, int modules, const PlacementRequest& request) {
  const bool isFixed = request.sizeMode == SizeMode::Fixed;
  const double outer = roomFactor(modules, request);
  const double most = isFixed ? request.sizeMm : request.maxSizeMm;
  const MapWindow window{kReachMargin * std::numbers::sqrt2 * outer * room, kReachTexels};
  CodeEstimate estimate;
  for (int round = 0; round < kRounds; ++round) {
    const auto normal = directionAt(surface, centre, sampled, looks, request);
    QRELIEF_TRY(normal);
    const ProjectionFrame upright = makeFrame(centre.position, *normal, request.upHint, request.eyeDistanceMm);
    auto reach = lookAround(surface.renderer, upright, window);
    QRELIEF_TRY(reach);
    double turn = toRadians(request.rotateDeg);
    if (request.mayTurn()) turn = bestTurn(*reach);
    const double free = reach->freeMm() / outer;
    estimate.frame = turned(upright, turn);
    estimate.rotationDeg = toDegrees(turn);
    estimate.guaranteedMm = std::min(free, most);
    estimate.symbolMm = isFixed                              ? most
                        : request.sizeMode == SizeMode::Free ? estimate.guaranteedMm
                                                             : std::min(most, reach->alignedMm(turn) / outer);
    estimate.bendMm = reach->bendMm(estimate.symbolMm, turn);
    estimate.missingFraction = isFixed ? reach->missingFraction(most * outer, turn) : 0;
    estimate.reach = std::make_shared<const VisibilityMap>(std::move(*reach));
    if (isFixed || request.direction || estimate.symbolMm >= kMuchSmaller * sampled || estimate.symbolMm <= 0) break;
    sampled = estimate.symbolMm;
  }
  return estimate;
}

}  // namespace

Result<CodeEstimate> estimateCode(const EstimatedSurface& surface, const SurfacePoint& centre, int modules,
                                  const PlacementRequest& request, std::optional<double> expectedMm) {
  if (request.sizeMode == SizeMode::Fixed)
    return estimateWithin(request.sizeMm, request.sizeMm, expectedMm ? kQuickDirectionLooks : kDirectionLooks, surface,
                          centre, modules, request);
  const double diagonal = surface.diagonalMm;
  const double most = std::min(request.maxSizeMm, diagonal);
  if (expectedMm && kAhead * *expectedMm < most) {
    auto near =
        estimateWithin(kAhead * *expectedMm, *expectedMm, kQuickDirectionLooks, surface, centre, modules, request);
    if (!near || std::max(near->guaranteedMm, near->symbolMm) < kAhead * *expectedMm) return near;
  }
  return estimateWithin(most, std::min(request.maxSizeMm, kFirstFraction * diagonal), kDirectionLooks, surface, centre,
                        modules, request);
}

}  // namespace qrelief
