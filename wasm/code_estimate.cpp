// SPDX-License-Identifier: GPL-3.0-or-later
#include "wasm/code_estimate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace qrelief {
namespace {

constexpr double kFirstShare = 0.15;  // of the model's diagonal: size that is sampled first, as PlacementSearch does
constexpr double kMuchSmaller = 0.6;  // a size below this share of the one sampled is sampled again
constexpr int kRounds = 2;
constexpr int kDirectionTexels = 48;
constexpr int kDirectionSamples = 256;
constexpr int kDirectionLooks = 2;
constexpr int kReachTexels = 128;
constexpr double kReachMargin = 1.05;
constexpr int kTurns = 18;  // that are tried for the best rotation, over a quarter turn

constexpr double kDegree = std::numbers::pi / 180;

Result<Vec3> directionAt(const EngravableModel& model, const GeometryPass& pass, const SurfacePoint& centre,
                         double sizeMm, const PlacementRequest& request) {
  if (request.direction) return *request.direction;
  DirectionOptions options;
  options.method =
      request.directionMethod == DirectionMethod::Optimal ? DirectionMethod::DepthBalanced : request.directionMethod;
  options.sizeMm = sizeMm;
  options.samples = kDirectionSamples;
  options.maxIterations = kDirectionLooks;
  options.mapTexels = kDirectionTexels;
  DirectionSearch search(pass, model.gpu, centre.position, triangleNormal(model.prepared.mesh, centre.triangle),
                         request.upHint, request.eyeDistanceMm, options);
  for (;;) {
    const Result<bool> found = search.step();
    if (!found) return tl::unexpected(found.error());
    if (*found) return search.normal();
  }
}

double bestTurn(const EyeReach& reach) {
  double best = 0, largest = reach.alignedMm(0);
  for (int i = 1; i < kTurns; ++i) {
    const double turn = (i * 90.0 / kTurns - (2 * i > kTurns ? 90 : 0)) * kDegree;
    const double fits = reach.alignedMm(turn);
    if (fits <= largest) continue;
    largest = fits;
    best = turn;
  }
  return best;
}

}  // namespace

Result<CodeEstimate> estimateCode(const EngravableModel& model, const GeometryPass& pass, const SurfacePoint& centre,
                                  int modules, const PlacementRequest& request) {
  const bool isFixed = request.sizeMode == SizeMode::Fixed;
  const double outer = roomFactor(modules, request.quietZone);
  const double diagonal = model.gpu.box().diagonal();
  const double most = isFixed ? request.sizeMm : request.maxSizeMm;
  const MapWindow window{kReachMargin * std::numbers::sqrt2 * outer * std::min(most, isFixed ? most : diagonal),
                         kReachTexels};
  CodeEstimate estimate;
  double sampled = isFixed ? most : std::min(most, kFirstShare * diagonal);
  for (int round = 0; round < kRounds; ++round) {
    const auto normal = directionAt(model, pass, centre, sampled, request);
    if (!normal) return tl::unexpected(normal.error());
    const ProjectionFrame upright = makeFrame(centre.position, *normal, request.upHint, request.eyeDistanceMm);
    auto reach = lookAround(pass, model.gpu, upright, window);
    if (!reach) return tl::unexpected(reach.error());
    double turn = request.rotateDeg * kDegree;
    if (request.sizeMode == SizeMode::Best) turn += bestTurn(*reach);
    const double free = reach->freeMm() / outer;
    estimate.frame = turned(upright, turn);
    estimate.rotationDeg = turn / kDegree;
    estimate.guaranteedMm = std::min(free, most);
    estimate.symbolMm = isFixed                              ? most
                        : request.sizeMode == SizeMode::Free ? estimate.guaranteedMm
                                                             : std::min(most, reach->alignedMm(turn) / outer);
    estimate.missingShare = isFixed ? reach->missingShare(most * outer, turn) : 0;
    estimate.reach = std::make_shared<const EyeReach>(std::move(*reach));
    if (isFixed || request.direction || estimate.symbolMm >= kMuchSmaller * sampled || estimate.symbolMm <= 0) break;
    sampled = estimate.symbolMm;
  }
  return estimate;
}

}  // namespace qrelief
