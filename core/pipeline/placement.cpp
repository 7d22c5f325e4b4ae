// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/clock.h"
#include "math/angle.h"
#include "mesh/ray.h"
#include "message_codes/pipeline.h"
#include "pipeline/placement_errors.h"
#include "projection/best_size.h"
#include "projection/crossings.h"
#include "projection/flatness.h"
#include "projection/size.h"
#include "projection/size_bound.h"

namespace qrelief {
namespace {

constexpr int kMaxRounds = 5;
constexpr double kSettledShare = 0.01;
constexpr double kEqualSizes = 1e-6;
constexpr double kFirstShare = 0.15;  // first estimate of the size, of the model's diagonal
constexpr double kFirstReach = 1.25;  // first search radius, of the expected size's half diagonal
constexpr double kNextReach = 1.5;    // growth of the search radius

// The search for the direction of the largest code.
constexpr double kFirstAngleDeg = 8, kLastAngleDeg = 2, kLarger = 1.001;
constexpr int kSides = 6, kMaxLooks = 36;

/// Largest magnification on the QR plane of a margin measured on the surface: surface nearer to the eye than the plane
/// looks larger, twice as large halfway to the eye.
constexpr double kNearnessFactor = 2;

class Stopwatch {
 public:
  explicit Stopwatch(double& sumMs) : sumMs_(sumMs) {}
  ~Stopwatch() { sumMs_ += millisecondsSince(start_); }

 private:
  double& sumMs_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

PlacementSearch::PlacementSearch(const PreparedModel& model, const SurfaceRenderer& surface, int modules,
                                 const PlacementRequest& request, Advice advice)
    : model_(&model), surface_(&surface), modules_(modules), request_(request), advice_(advice) {}

double PlacementSearch::outerFactor() const { return roomFactor(modules_, request_); }

ProjectionFrame PlacementSearch::frameFor(Vec3 normal) const {
  return turned(makeFrame(placement_.frame.centre, normal, request_.upHint, request_.eyeDistanceMm),
                toRadians(request_.rotateDeg));
}

Status PlacementSearch::start() {
  const auto surface = closestPoint(model_->mesh, request_.centreMm);
  if (!surface) return badInput(message<"no-surface">());
  placement_.seed = surface->triangle;
  placement_.frame.centre = surface->position;
  surfaceNormal_ = surfaceNormalAt(model_->mesh, *surface);
  fitMm_ = std::min(request_.maxSizeMm, kFirstShare * boundingBox(model_->mesh).diagonal());
  if (request_.direction) return measure(*request_.direction, advice_);
  if (request_.sizeMode == SizeMode::Fixed) return {};
  // A single facet's normal is unreliable: from that direction the code may be tiny or not fit at all, although it is
  // large from others.
  const double expected = fitMm_;
  const Status measured = measure(surfaceNormal_);
  fitMm_ = measured ? std::max(expected, fitMm_) : expected;
  fits_.clear();
  return {};
}

double PlacementSearch::largestMm() const {
  return request_.sizeMode == SizeMode::Fixed ? std::max(request_.maxSizeMm, request_.sizeMm) : request_.maxSizeMm;
}

/// Returns half the diagonal of the square that must fit for a symbol of an edge, mm.
double PlacementSearch::halfDiagonalMm(double symbolMm) const {
  return symbolMm * outerFactor() * std::numbers::sqrt2 / 2;
}

/// @param finder  for the frame; replaced if it is for another radius
Result<VisiblePatch> PlacementSearch::patchWithin(const ProjectionFrame& frame, double radiusMm, GrowingRegion region,
                                                  std::optional<SilhouetteFinder>& finder) {
  if (!finder || finder->radiusMm() != radiusMm)
    finder.emplace(model_->mesh, model_->adjacency, frame, radiusMm, model_->clusters.get());
  auto patch = finder->find(placement_.seed, region);
  if (!patch || !model_->hasCrossings) return patch;
  if (const Status added = addCrossings(model_->mesh, frame, *patch, knownCrossings()); !added) {
    meetsCrossings_ = true;
    return tl::unexpected(added.error());
  }
  return patch;
}

/// Returns the part of the patch that decides the size. Searches as far as the code is expected to reach, then farther
/// and farther, until a silhouette bounds the size or the size is the largest allowed.
Result<VisiblePatch> PlacementSearch::decisivePatch(const ProjectionFrame& frame, GrowingRegion region,
                                                    std::optional<SilhouetteFinder>& finder) {
  const double farthest = halfDiagonalMm(largestMm());
  double radius = std::min(farthest, kFirstReach * halfDiagonalMm(sampledMm()));
  for (;;) {
    auto patch = patchWithin(frame, radius, region, finder);
    if (!patch || radius >= farthest) return patch;
    if (halfDiagonalMm(sizeWithin(patch->silhouette, region)) <= radius) return patch;
    radius = std::min(farthest, kNextReach * radius);
  }
}

/// Returns the largest symbol that fits in the silhouette: for a square upright, for a disc at every rotation, or at
/// the best one if the search may turn the code.
double PlacementSearch::sizeWithin(std::span<const Segment2> silhouette, GrowingRegion region) const {
  const double most = largestMm() * outerFactor();
  const double size = region == GrowingRegion::Square ? orientedSize(silhouette)
                      : request_.mayTurn()            ? bestSize(silhouette, most).sizeMm
                                                      : freeSize(silhouette);
  return std::min(most, size) / outerFactor();
}

PlacementSearch::Fit PlacementSearch::fitIn(VisiblePatch patch, const ProjectionFrame& frame, Fit::Turn turn) const {
  Fit fit{turn, {}};
  Placement& placed = fit.placement;
  placed.frame = frame;
  placed.seed = placement_.seed;
  placed.iterations = placement_.iterations;
  placed.rotationDeg = request_.rotateDeg;
  const bool isForDisc = turn == Fit::Turn::EveryRotation;
  placed.symbolMm = isForDisc ? std::min(largestMm(), freeSize(patch.silhouette) / outerFactor())
                              : sizeWithin(patch.silhouette, GrowingRegion::Square);
  placed.patch = std::move(patch);
  return fit;
}

/// Turns the code so that it is largest within the patch for a disc.
Result<PlacementSearch::Fit> PlacementSearch::turnedFit(const VisiblePatch& disc, const ProjectionFrame& frame) {
  const double rotation = bestSize(disc.silhouette, largestMm() * outerFactor()).rotation;
  const ProjectionFrame turnedFrame = turned(frame, rotation);
  std::optional<SilhouetteFinder> finder;
  auto square =
      disc.partlyHidden ? decisivePatch(turnedFrame, GrowingRegion::Square, finder) : Result<VisiblePatch>(disc);
  QRELIEF_TRY(square);
  if (!disc.partlyHidden) square->silhouette = inTurnedAxes(disc.silhouette, rotation);
  Fit fit = fitIn(std::move(*square), turnedFrame, Fit::Turn::ToFit);
  fit.placement.rotationDeg = toDegrees(rotation);
  return fit;
}

/// Returns the ways in which the code fits from a direction, walls ignored. The first is for every rotation.
Result<std::vector<PlacementSearch::Fit>> PlacementSearch::fitsFrom(const ProjectionFrame& frame) {
  const bool isFree = request_.sizeMode == SizeMode::Free;
  const bool needsDisc = isFree || request_.mayTurn();
  std::optional<SilhouetteFinder> finder;
  auto disc = decisivePatch(frame, needsDisc ? GrowingRegion::Disc : GrowingRegion::Square, finder);
  QRELIEF_TRY(disc);
  auto square = disc;  // the same for both regions if nothing is partly hidden
  if (disc->partlyHidden && !isFree) {
    auto& other = needsDisc ? square : disc;
    other = decisivePatch(frame, needsDisc ? GrowingRegion::Square : GrowingRegion::Disc, finder);
    QRELIEF_TRY(other);
  }

  std::vector<Fit> fits;
  if (request_.mayTurn()) {
    auto fit = turnedFit(*disc, frame);
    QRELIEF_TRY(fit);
    fits.push_back(std::move(*fit));
  }
  fits.insert(fits.begin(), fitIn(std::move(*disc), frame, Fit::Turn::EveryRotation));
  if (!isFree) fits.insert(fits.begin() + 1, fitIn(std::move(*square), frame, Fit::Turn::Upright));
  const double guaranteedMm = fits.front().placement.symbolMm;
  for (Fit& fit : fits) {
    fit.placement.guaranteedMm = guaranteedMm;
    fit.placement.largestMm = std::max(guaranteedMm, fit.placement.symbolMm);
  }
  return fits;
}

/// Returns the largest fit, but an upright one rather than one that is turned and hardly larger. Of equal ones, the
/// last.
PlacementSearch::Fit& PlacementSearch::fitToTake(std::vector<Fit>& fits) {
  Fit *upright = nullptr, *turnedToFit = nullptr;
  for (Fit& fit : fits) {
    Fit*& best = fit.turn == Fit::Turn::ToFit ? turnedToFit : upright;
    if (!best || fit.placement.symbolMm * (1 + kEqualSizes) >= best->placement.symbolMm) best = &fit;
  }
  const bool isTurned = turnedToFit && upright->placement.symbolMm < kUprightFraction * turnedToFit->placement.symbolMm;
  return isTurned ? *turnedToFit : *upright;
}

Status PlacementSearch::measure(Vec3 normal, Advice advice) {
  const Stopwatch stopwatch(sizeMs_);
  const bool isFixed = request_.sizeMode == SizeMode::Fixed;
  auto fits = fitsFrom(frameFor(normal));
  QRELIEF_TRY(fits);
  placement_ = fitToTake(*fits).placement;
  fitMm_ = placement_.symbolMm;
  if (isFixed) placement_.symbolMm = request_.sizeMm;
  placement_.moduleMm = placement_.symbolMm / modules_;
  const double leastMm = kMinModuleMm * modules_;
  const double wantedMm = isFixed ? request_.sizeMm : std::min(request_.maxSizeMm, leastMm);
  NoRoom room{*model_, request_, modules_, {}};
  if (fitMm_ * (1 + kEqualSizes) < wantedMm) {
    const auto crossing = crossingWithin(halfDiagonalMm(wantedMm));
    QRELIEF_TRY(crossing);
    room.crossing = *crossing;
    meetsCrossings_ = meetsCrossings_ || room.crossing;
    if (room.crossing && fitMm_ < leastMm && isAtCentre(*room.crossing))
      return tl::unexpected(crossingAtCentre(room, placement_.frame.centre));
  }
  if (isFixed && fitMm_ * (1 + kEqualSizes) < request_.sizeMm)
    return tl::unexpected(tooLarge(room, fittingSizes(advice)));
  if (placement_.moduleMm < kMinModuleMm)
    return tl::unexpected(isFixed || fitMm_ >= request_.maxSizeMm ? tooSmallAsAsked(room, placement_.symbolMm)
                                                                  : tooSmallHere(room, placement_.symbolMm));
  if (request_.sizeMode != SizeMode::Best) fits_.clear();
  if (isFixed) *fits = {Fit{Fit::Turn::Upright, placement_}};
  fits_.insert(fits_.end(), std::move_iterator(fits->begin()), std::move_iterator(fits->end()));
  return {};
}

/// Returns the place nearest to the centre, at most `radiusMm` away, where triangles cross; none if there is none.
Result<std::optional<Vec3>> PlacementSearch::crossingWithin(double radiusMm) const {
  if (!model_->hasCrossings) return std::nullopt;
  const Vec3 centre = placement_.frame.centre;
  auto crossing = nearestCrossing(model_->mesh, placement_.patch.triangles, centre, knownCrossings());
  if (crossing && *crossing && glm::distance(**crossing, centre) > radiusMm) return std::nullopt;
  return crossing;
}

bool PlacementSearch::wouldMeetCrossings(double symbolMm) const {
  const auto crossing = crossingWithin(halfDiagonalMm(symbolMm));
  return !crossing || crossing->has_value();  // an error: too many to list
}

/// Returns true if triangles cross nearer to the centre than half the edge of the smallest code. No code then fits at
/// any rotation.
bool PlacementSearch::isAtCentre(Vec3 crossing) const {
  return glm::distance(crossing, placement_.frame.centre) <= kMinModuleMm * modules_ * outerFactor() / 2;
}

/// Finds the largest sizes that fit, to be named in the error. A turned code is measured at the rotation as rounded for
/// the message.
FittingSizes PlacementSearch::fittingSizes(Advice advice) {
  FittingSizes fitting{.hereMm = fitMm_, .everywhereMm = placement_.guaranteedMm};
  if (advice == Advice::None) return fitting;
  std::optional<SilhouetteFinder> finder;
  const auto farthest = patchWithin(placement_.frame, halfDiagonalMm(largestMm()), GrowingRegion::Square, finder);
  const std::vector<Segment2>& silhouette = farthest ? farthest->silhouette : placement_.patch.silhouette;
  const double foundDeg = toDegrees(bestSize(silhouette, largestMm() * outerFactor()).rotation);
  fitting.turnedDeg = std::round(std::remainder(request_.rotateDeg + foundDeg, 360) * 10) / 10;
  const double turn = toRadians(fitting.turnedDeg - request_.rotateDeg);
  fitting.turnedMm = std::min(largestMm(), orientedSize(inTurnedAxes(silhouette, turn)) / outerFactor());
  return fitting;
}

double PlacementSearch::sampledMm() const {
  if (request_.sizeMode == SizeMode::Fixed) return request_.sizeMm;
  return std::max(fitMm_, kMinModuleMm * modules_);  // 0 fits at a centre on a silhouette
}

DirectionOptions PlacementSearch::directionOptions() const {
  DirectionOptions options;
  options.method = request_.directionMethod;
  options.sizeMm = sampledMm();
  return options;
}

/// Measures from the first of several directions from which the code fits; else returns the first direction's error.
Status PlacementSearch::measureFirstFitting(std::span<const Vec3> normals) {
  const Status first = measure(normals.front());
  if (first) return first;
  for (const Vec3 normal : normals.subspan(1))
    if (measure(normal)) return {};
  return advice_ == Advice::None ? first : measure(normals.front(), advice_);
}

/// Returns the directions to try: the one found, then the others by increasing variance, as the code may not fit from
/// the best. The single facet's normal comes last.
std::vector<Vec3> PlacementSearch::roundCandidates() const {
  std::vector<DirectionIteration> looks(placement_.iterations.begin() + 1, placement_.iterations.end());
  std::stable_sort(looks.begin(), looks.end(), [](const DirectionIteration& a, const DirectionIteration& b) {
    return a.varianceMm2 < b.varianceMm2;
  });
  std::vector<Vec3> normals{direction_->normal()};
  for (const DirectionIteration& look : looks)
    if (look.normal != normals.front()) normals.push_back(look.normal);
  if (placement_.iterations.front().normal != normals.front()) normals.push_back(placement_.iterations.front().normal);
  return normals;
}

/// Does one step of the search for the optimal direction. At the end, takes the best direction from which the code
/// fits; it fits from the first.
Result<bool> PlacementSearch::refine() {
  {
    const Stopwatch stopwatch(directionMs_);
    const Result<bool> isDone = optimal_->step();
    if (!isDone || !*isDone) return isDone;
  }
  placement_.iterations = optimal_->iterations();
  std::vector<DirectionIteration> looks = optimal_->iterations();
  std::stable_sort(looks.begin(), looks.end(),
                   [](const DirectionIteration& a, const DirectionIteration& b) { return a.measure < b.measure; });
  std::vector<Vec3> normals{optimal_->normal()};
  for (const DirectionIteration& look : looks) {
    if (look.normal == normals.front()) continue;
    normals.push_back(look.normal);
    if (look.normal == optimal_->iterations().front().normal) break;
  }
  fits_.clear();
  QRELIEF_TRY(measureFirstFitting(normals));
  return true;
}

/// Does one look of the search for the direction of the largest code.
/// @returns true when done
bool PlacementSearch::grow() {
  if (!growth_) {
    const Placement& largest = fitToTake(fits_).placement;
    growth_ = Growth{largest.frame.normal, largest.symbolMm, kFirstAngleDeg};
  }
  Growth& growth = *growth_;
  if (growth.angleDeg < kLastAngleDeg || growth.looks == kMaxLooks || growth.bestMm >= largestMm()) return true;
  const ProjectionFrame round = frameFor(growth.best);
  const double side = 2 * std::numbers::pi / kSides * growth.side, angle = toRadians(growth.angleDeg);
  const Vec3 sideways = round.right * std::cos(side) + round.up * std::sin(side);
  ++growth.looks;
  if (++growth.side == kSides) {
    growth.side = 0;
    growth.angleDeg /= 2;
  }
  const Placement before = placement_;
  std::vector<Fit> known = std::move(fits_);
  fits_.clear();
  const Vec3 normal = growth.best * std::cos(angle) + sideways * std::sin(angle);
  if (measure(normal) && fitMm_ >= kLarger * growth.bestMm) {
    growth = {normal, fitMm_, toDegrees(angle), 0, growth.looks};
    known.insert(known.end(), std::move_iterator(fits_.begin()), std::move_iterator(fits_.end()));
  } else {
    placement_ = before;
    fitMm_ = growth.bestMm;
  }
  fits_ = std::move(known);
  return false;
}

/// Extends the patch of a fit by the margin for walls.
Status PlacementSearch::extend(Fit& fit) {
  Placement& placed = fit.placement;
  const double radius = halfDiagonalMm(placed.symbolMm) + kNearnessFactor * request_.beyondMm;
  if (radius <= placed.patch.radiusMm) return {};
  const bool isForDisc = fit.turn == Fit::Turn::EveryRotation;
  std::optional<SilhouetteFinder> finder;
  auto patch = patchWithin(placed.frame, radius, isForDisc ? GrowingRegion::Disc : GrowingRegion::Square, finder);
  QRELIEF_TRY(patch);
  placed.patch = std::move(*patch);
  return {};
}

/// Reduces a found size if walls are too thin for its pockets. If they take no code at all, keeps the size; the depth
/// search then decides whether anything can be carved.
Status PlacementSearch::leaveWalls(Fit& fit) {
  fit.leavesWalls = true;
  QRELIEF_TRY(extend(fit));
  const PocketDemand& pockets = request_.pockets;
  if (request_.sizeMode == SizeMode::Fixed || !(pockets.depth(1) > 0)) return {};
  Placement& placed = fit.placement;
  const CellSquare square{placed.symbolMm, modules_};
  const bool isAnyWayUp = fit.turn == Fit::Turn::EveryRotation;  // its size does not depend on a rotation
  const ProjectionFrame frame = isAnyWayUp ? turned(placed.frame, -toRadians(request_.rotateDeg)) : placed.frame;
  const auto walls = measureModuleWalls(model_->mesh, *surface_, frame, placed.patch, square,
                                        pockets.depth(placed.symbolMm / modules_), pockets.minWallMm);
  QRELIEF_TRY(walls);
  const double taken = sizeThatWallsTake(*walls, square, modules_, pockets.depthModules, pockets.depthMm);
  if (taken >= kMinModuleMm * modules_) placed.symbolMm = taken;
  return {};
}

/// Does one step of the search for a free size, and measures the best size from its direction at the end.
/// @returns true when done
bool PlacementSearch::lookFromFree() {
  const Result<bool> isDone = free_->step();
  if (isDone && !*isDone) return false;
  directionMs_ += free_->directionMs_;
  sizeMs_ += free_->sizeMs_;
  if (isDone) {
    placement_.iterations = free_->placement().iterations;
    std::vector<Fit> earlier = std::move(fits_);
    fits_.clear();
    measure(free_->placement().frame.normal);  // an error leaves the earlier fits
    fits_.insert(fits_.end(), std::move_iterator(earlier.begin()), std::move_iterator(earlier.end()));
  }
  free_.reset();
  return true;
}

/// Returns the size that fits at every rotation from a direction, with walls counted.
Result<double> PlacementSearch::sizeAnyWayUp(Vec3 normal) {
  const auto fit = std::find_if(fits_.begin(), fits_.end(), [&](const Fit& one) {
    return one.turn == Fit::Turn::EveryRotation && one.placement.frame.normal == normal;
  });
  if (!fit->leavesWalls) QRELIEF_TRY(leaveWalls(*fit));
  return fit->placement.symbolMm;
}

/// Takes the best fit with walls counted. Walls only reduce sizes, so most need not be measured.
Status PlacementSearch::takeBestFit() {
  const Stopwatch stopwatch(sizeMs_);
  Fit* best = &fitToTake(fits_);
  while (!best->leavesWalls) {
    QRELIEF_TRY(leaveWalls(*best));
    best = &fitToTake(fits_);
  }
  if (request_.sizeMode != SizeMode::Fixed) {
    const auto guaranteedMm = sizeAnyWayUp(best->placement.frame.normal);
    QRELIEF_TRY(guaranteedMm);
    best->placement.guaranteedMm = *guaranteedMm;
  }
  placement_ = std::move(best->placement);
  placement_.moduleMm = placement_.symbolMm / modules_;
  fits_.clear();
  return {};
}

/// Does one step of the search for direction and size, and for the free size if the best one is wanted.
/// @returns true when done
Result<bool> PlacementSearch::find() {
  if (free_) {
    if (!lookFromFree()) return false;
    if (fits_.empty()) return tl::unexpected(*doesNotFit_);
    return true;
  }
  Result<bool> done = searchOnce();
  const bool isBest = request_.sizeMode == SizeMode::Best && !request_.direction && !optimal_;
  const bool mayGrow = done ? *done && fitMm_ < largestMm() : done.error().kind == ErrorKind::NoSolution;
  if (!isBest || !mayGrow) return done;
  if (!done) doesNotFit_ = done.error();
  PlacementRequest free = request_;
  free.sizeMode = SizeMode::Free;
  if (free.directionMethod == DirectionMethod::Largest) free.directionMethod = DirectionMethod::DepthBalanced;
  free_ = std::make_unique<PlacementSearch>(*model_, *surface_, modules_, free);
  return false;
}

Result<bool> PlacementSearch::step() {
  if (!isFound_) {
    const Result<bool> done = find();
    if (!done || !*done) return done;
    isFound_ = true;
  }
  const bool isForLargest = request_.directionMethod == DirectionMethod::Largest && !request_.direction &&
                            request_.sizeMode != SizeMode::Fixed;
  if (isForLargest && !grow()) return false;
  QRELIEF_TRY(takeBestFit());
  placement_.bendMm = bendMm(model_->mesh, placement_.patch.triangles, placement_.frame, placement_.symbolMm);
  return true;
}

Result<bool> PlacementSearch::searchOnce() {
  if (!started_) {
    started_ = true;
    QRELIEF_TRY(start());
    return request_.direction.has_value();
  }
  if (optimal_) return refine();
  if (!direction_)
    direction_.emplace(*surface_, placement_.frame.centre, surfaceNormal_, request_.upHint, request_.eyeDistanceMm,
                       directionOptions());
  {
    const Stopwatch stopwatch(directionMs_);
    const Result<bool> isDone = direction_->step();
    if (!isDone || !*isDone) return isDone;
    placement_.iterations = direction_->iterations();
  }
  const double before = fitMm_;
  QRELIEF_TRY(measureFirstFitting(roundCandidates()));
  direction_.reset();
  ++round_;
  const bool settled = request_.sizeMode == SizeMode::Fixed || round_ >= kMaxRounds ||
                       std::abs(fitMm_ - before) < kSettledShare * before;
  if (settled && request_.directionMethod == DirectionMethod::Optimal) {
    optimal_.emplace(*surface_, placement_.frame.centre, placement_.frame.normal, request_.upHint,
                     request_.eyeDistanceMm, directionOptions());
    return false;
  }
  return settled;
}

}  // namespace qrelief
