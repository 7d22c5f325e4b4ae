// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/spot_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <tuple>

#include "base/clock.h"
#include "base/job_stages.h"
#include "base/parallel.h"
#include "math/angle.h"
#include "math/round_down.h"
#include "message_codes/pipeline.h"
#include "message_codes/settings_errors.h"
#include "message_codes/stages.h"
#include "pipeline/default_patterns.h"
#include "pipeline/label_pockets.h"
#include "pipeline/mark_depth.h"
#include "pipeline/placement_errors.h"
#include "pipeline/spot_concerns.h"
#include "pipeline/spot_light.h"
#include "pipeline/spot_trial.h"
#include "projection/size.h"
#include "projection/size_bound.h"
#include "settings/settings.h"

namespace qrelief {
namespace {

constexpr double kSliceMs = 30;     // time to draw views or test spots in one piece of work
constexpr double kMapMayErr = 0.9;  // test spots whose size in the map is this share of the size needed, or 1/√2 of it,
                                    // as some spots fit at one rotation only
constexpr std::size_t kTriesPerSpot = 4;
constexpr std::size_t kLeastTries = 8;
constexpr std::size_t kLargestTried = 3;       // spots tried for the largest size if the requested size fits nowhere
constexpr std::size_t kComparedForColour = 3;  // candidates whose layers are compared, for each requested spot
constexpr double kUnaskedShare = 0.1;          // least square of the map if no size is requested, of the diagonal
constexpr std::size_t kMostTrials = 4;         // at the same time: each takes some MB on a large model

/// Returns the least square that the map must show if no size is requested.
double unaskedLeastMm(const EngravableModel& model) {
  return kUnaskedShare * boundingBox(model.prepared.mesh).diagonal();
}

/// Checks the settings shared with engraving by the same rules.
Status checkRequest(const SpotSearchRequest& request) {
  QRELIEF_TRY(checkSettings(request.placement));
  QRELIEF_TRY(checkSettings(DepthRequest{.minWallMm = request.minWallMm}));
  if (request.count >= 1 && request.count <= kMaxSpots) return {};
  return fail(ErrorKind::BadUsage,
              message<"place-count">(with::count<"count">(request.count), with::count<"max">(kMaxSpots)));
}

/// Returns the binary logarithm of a number of layers, rounded down: only twice as many layers make a spot worse.
int doublings(int layers) { return layers > 0 ? std::ilogb(layers) : 0; }

bool isUneven(const Spot& spot) { return spot.unevenLight > kMostUnevenLight; }

}  // namespace

int centreDecimals(double scaleToMm) {
  return std::clamp(3 + static_cast<int>(std::ceil(std::log10(scaleToMm))), 0, 15);
}

struct SpotSearchJob::State {
  struct Candidate : SpotCandidate {
    std::optional<bool> isDoubtful = {};  ///< none: not screened yet
  };
  /// The test of a candidate, and its last answer.
  struct Trial {
    SpotTrial test;
    Result<bool> isDone = false;

    bool goesOn() const { return isDone && !*isDone; }
    void advance(double ms);
  };

  std::shared_ptr<const EngravableModel> model;
  SpotSearchRequest request;
  JobStages<State> stages = stagesOf();
  bool findsLargest = false;  // true once the requested size has been found to fit nowhere
  std::optional<SizeMapSearch> mapping;
  double outer = 1;  // request.outerFactor()

  std::vector<Candidate> candidates;
  std::size_t candidate = 0;
  // Order of the candidates: first the `likely` ones, which take the size according to the map, with the `deferred`
  // doubtful ones last among them; then all others. The first `screened` have been checked.
  std::size_t likely = 0, screened = 0, deferred = 0;
  std::size_t recalled = 0;   // candidates before this one were recalled: tested until enough spots print
  std::vector<Trial> trials;  // of the next candidates
  std::size_t tooThin = 0;
  double thickestMm = 0;  // the thickest of these walls
  bool isOrderedByLayers = false;
  bool meetsCrossings = false;  // true once crossing triangles kept a code away
  std::optional<Spot> largest;  // largest spot that takes less than the requested size
  SpotSearchResult result;

  std::size_t goodSpots() const {  // counts small ones, too: later spots are hardly larger
    return static_cast<std::size_t>(std::count_if(result.spots.begin(), result.spots.end(), [](const Spot& spot) {
      return spot.takesPockets && !spot.coversColours && !spot.facesDown && !isUneven(spot);
    }));
  }
  std::size_t printableSpots() const {
    return static_cast<std::size_t>(std::count_if(result.spots.begin(), result.spots.end(),
                                                  [](const Spot& spot) { return spot.prints && !spot.facesDown; }));
  }
  bool hasEnough() const {
    const bool isEnough = result.spots.size() >= request.count;
    return goodSpots() >= request.count || (isEnough && (goodSpots() > 0 || candidate >= likely));
  }
  std::size_t mostTries() const { return kLeastTries + kTriesPerSpot * request.count; }
  bool fixed() const { return request.placement.sizeMode == SizeMode::Fixed; }
  static JobStages<State> stagesOf();
  double mostInMap() const;
  void startMap(double leastMm);
  Result<StageStep> drawViews();
  void propose(double leastSizeMm);
  bool isDoubtful(const SpotCandidate& spot) const;
  bool screen(std::size_t at, std::size_t end);
  ProjectionFrame frameAt(const SpotCandidate& spot) const;
  int doublingsAt(const SpotCandidate& spot) const;
  void orderByLayers();
  bool recallDeferred();
  bool isEnough(std::size_t at, std::size_t moreSpots) const;
  std::size_t mostTrials() const;
  bool beginTrials();
  Result<StageStep> testOnce();
  void take(const SpotTrial& trial);
  Result<StageStep> finishTests();
  Error nothingFound() const;
  double testedShare() const;
};

JobStages<SpotSearchJob::State> SpotSearchJob::State::stagesOf() {
  return {{message<"looking-from-all-sides">(), 60, &State::drawViews},
          {message<"testing-spots">(), 40, &State::testOnce}};
}

double SpotSearchJob::State::mostInMap() const {
  const std::vector<float>& sizes = result.map->sizeMm;
  return static_cast<double>(*std::max_element(sizes.begin(), sizes.end()));
}

/// @param leastMm  smallest square that the map must show
void SpotSearchJob::State::startMap(double leastMm) {
  SizeMapOptions options;
  options.eyeDistanceMm = request.placement.eyeDistanceMm;
  options.minMm = leastMm;
  options.views = request.views;
  options.onlyFrom = request.placement.direction;
  if (request.known && request.known->options == options)
    result.map = request.known;
  else
    mapping.emplace(model->prepared.mesh, model->prepared.normals, options);
}

Result<StageStep> SpotSearchJob::State::drawViews() {
  const auto start = Clock::now();
  while (mapping && millisecondsSince(start) < kSliceMs) {
    if (!mapping->step()) continue;
    result.map = std::make_shared<const SizeMap>(mapping->takeMap());
    mapping.reset();
  }
  if (mapping) return StageStep{mapping->doneFraction()};
  propose(fixed() && !findsLargest ? kMapMayErr * request.placement.sizeMm * outer / std::numbers::sqrt2 : 0);
  return kStageDone;
}

void SpotSearchJob::State::propose(double leastSizeMm) {
  CandidateOptions options;
  options.edgeMm = std::min(wantedMm(request) * outer, std::max(mostInMap(), 1e-3));
  options.minSizeMm = leastSizeMm;
  options.enoughMm = std::max(wantedMm(request), request.placement.maxSizeMm) * outer;
  candidates.clear();
  for (const SpotCandidate& spot : spotCandidates(*result.map, options)) candidates.push_back({spot});
  candidate = 0;
  screened = deferred = recalled = 0;
  isOrderedByLayers = false;
  const double takes = fixed() && !findsLargest ? kMapMayErr * request.placement.sizeMm * outer : 0;
  const auto unlikely = std::stable_partition(candidates.begin(), candidates.end(),
                                              [&](const SpotCandidate& spot) { return spot.sizeMm >= takes; });
  likely = static_cast<std::size_t>(unlikely - candidates.begin());
}

/// Returns the frame of a code on a candidate, as the map has it.
ProjectionFrame SpotSearchJob::State::frameAt(const SpotCandidate& spot) const {
  return makeFrame(spot.position, spot.direction, request.placement.upHint, request.placement.eyeDistanceMm);
}

bool SpotSearchJob::State::isDoubtful(const SpotCandidate& spot) const {
  const ProjectionFrame frame = frameAt(spot);
  const double symbolMm = std::min(wantedMm(request), spot.sizeMm / outer);
  return facesDown(frame, request) || unevenLightOn(*model, frame, symbolMm, request) > kMostUnevenLight;
}

/// Screens a candidate at a tenth of a test's cost, and moves a doubtful one behind the other likely ones.
/// @param end  the candidates before it will be screened next; up to kMostTrials of them are screened in parallel
/// @returns false if the candidate at that index needs no screening
bool SpotSearchJob::State::screen(std::size_t at, std::size_t end) {
  const std::size_t unscreened = likely - deferred;
  if (screened > at || at >= unscreened || findsLargest || screened + deferred >= mostTries()) return false;
  if (!candidates[at].isDoubtful)
    parallelFor(std::min({kMostTrials, end - at, unscreened - at}), [&](std::size_t i) {
      Candidate& next = candidates[at + i];
      if (!next.isDoubtful) next.isDoubtful = isDoubtful(next);
    });
  if (!*candidates[at].isDoubtful) {
    screened = at + 1;
    return true;
  }
  const auto doubtful = candidates.begin() + static_cast<std::ptrdiff_t>(at);
  std::rotate(doubtful, doubtful + 1, candidates.begin() + static_cast<std::ptrdiff_t>(likely));
  ++deferred;
  return true;
}

/// Estimates doublings() of the layers that a code in a second colour has on a candidate. Uses the surface's mean
/// normal: the map's direction is tilted against it, so on a flat face a larger code would seem to need more layers.
int SpotSearchJob::State::doublingsAt(const SpotCandidate& spot) const {
  Placement placement;
  placement.frame = frameAt(spot);
  if (!request.placement.direction && spot.quality.normal != Vec3(0))
    placement.frame =
        makeFrame(spot.position, spot.quality.normal, request.placement.upHint, request.placement.eyeDistanceMm);
  placement.moduleMm = std::min(wantedMm(request), spot.sizeMm / outer) / request.modules;
  return doublings(layersOfCode(placement, request.modules, *request.coloured));
}

/// Sorts the screened candidates by the layers that a code in a second colour has there, fewest first.
void SpotSearchJob::State::orderByLayers() {
  assert(candidate == 0);
  isOrderedByLayers = true;
  std::stable_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(screened),
                   [&](const SpotCandidate& a, const SpotCandidate& b) { return doublingsAt(a) < doublingsAt(b); });
}

/// Puts the deferred candidates that are large enough to print before all others, if no spot so far is large enough.
/// @returns false if there are none
bool SpotSearchJob::State::recallDeferred() {
  if (findsLargest || deferred == 0 || candidate >= likely || printableSpots() > 0) return false;
  const auto at = [&](std::size_t i) { return candidates.begin() + static_cast<std::ptrdiff_t>(i); };
  const auto first = at(std::max(candidate, likely - deferred));
  const auto end = std::stable_partition(first, at(likely), [&](const SpotCandidate& spot) {
    return spot.sizeMm >= kMapMayErr * request.leastPrintableMm * outer;
  });
  deferred = 0;
  recalled = screened = candidate + static_cast<std::size_t>(end - first);
  std::rotate(at(candidate), first, end);
  return recalled > candidate;
}

/// Returns true if the candidate at that index need not be tested.
/// @param moreSpots  greatest number of spots that the candidates before it may still give
bool SpotSearchJob::State::isEnough(std::size_t at, std::size_t moreSpots) const {
  if (at >= candidates.size()) return true;
  if (findsLargest) return at >= kLargestTried;
  if (at < recalled) return printableSpots() + moreSpots >= request.count;
  const bool mayBeEnough = moreSpots > 0 && result.spots.size() + moreSpots >= request.count;
  return mayBeEnough || hasEnough() || at >= mostTries();
}

/// Returns the number of candidates to test at the same time. A GPU draws for one at a time.
std::size_t SpotSearchJob::State::mostTrials() const { return model->renderer == model->raster ? kMostTrials : 1; }

/// Begins the tests of the next candidates: of one at least, and of more only if each is needed whatever the others
/// give. So the result does not depend on their number.
/// @returns false if a candidate was screened instead
bool SpotSearchJob::State::beginTrials() {
  if (request.coloured && !isOrderedByLayers) {
    const std::size_t compared = kComparedForColour * request.count;
    if (screened < compared && screen(screened, compared)) return false;
    orderByLayers();
  }
  std::size_t count = 1;
  while (count < mostTrials() && !isEnough(candidate + count, count)) ++count;
  for (std::size_t i = 0; i < count; ++i)
    if (screen(candidate + i, candidate + count)) return false;
  for (std::size_t i = 0; i < count; ++i)
    trials.push_back({SpotTrial(*model, request, *result.map, candidates[candidate + i], findsLargest)});
  return true;
}

/// Does steps until the time is over.
void SpotSearchJob::State::Trial::advance(double ms) {
  const auto start = Clock::now();
  while (goesOn() && millisecondsSince(start) < ms) isDone = test.step();
}

void SpotSearchJob::State::take(const SpotTrial& trial) {
  ++candidate;
  result.tried += trial.tries();
  if (const auto wallMm = trial.thinWallMm()) {
    ++tooThin;
    thickestMm = std::max(thickestMm, *wallMm);
  }
  meetsCrossings = meetsCrossings || trial.meetsCrossings();
  if (!trial.spot()) return;
  if (!findsLargest)
    result.spots.push_back(*trial.spot());
  else if (!largest || trial.spot()->symbolMm > largest->symbolMm)
    largest = trial.spot();
}

Result<StageStep> SpotSearchJob::State::testOnce() {
  if (trials.empty()) {
    if (isEnough(candidate, 0) && !recallDeferred()) return finishTests();
    if (!beginTrials()) return StageStep{testedShare()};
  }
  const double sliceMs = kSliceMs / static_cast<double>(trials.size());
  parallelFor(trials.size(), [&](std::size_t i) { trials[i].advance(sliceMs); });
  if (std::any_of(trials.begin(), trials.end(), [](const Trial& trial) { return trial.goesOn(); }))
    return StageStep{testedShare()};
  for (const Trial& trial : trials) {
    QRELIEF_TRY(trial.isDone);
    take(trial.test);
  }
  trials.clear();
  return StageStep{testedShare()};
}

Result<StageStep> SpotSearchJob::State::finishTests() {
  if (findsLargest) return tl::unexpected(nothingFound());
  if (result.spots.empty()) {
    findsLargest = true;
    const bool draws = result.map->viewsDropped > 0;  // these views may take a smaller code
    stages.add({message<"finding-largest-size">(), 60, &State::drawViews, draws});
    stages.add({message<"finding-largest-size">(), 10, &State::testOnce});
    if (draws)
      startMap(unaskedLeastMm(*model));
    else
      propose(0);
    return kStageDone;
  }
  const auto rank = [&](const Spot& spot) {
    return SpotRank(fixed() ? spot.guaranteedMm : spot.symbolMm, spot.quality, spot.symbolMm * outer,
                    spot.aimToleranceDeg);
  };
  // Doubts in order of importance.
  const auto doubts = [](const Spot& spot) {
    return std::tuple(!spot.prints, !spot.takesPockets, spot.coversColours, spot.facesDown, isUneven(spot),
                      doublings(spot.colourLayers), spot.needsDirection);
  };
  std::stable_sort(result.spots.begin(), result.spots.end(), [&](const Spot& a, const Spot& b) {
    return doubts(a) != doubts(b) ? doubts(a) < doubts(b) : rank(a) < rank(b);
  });
  if (result.spots.size() > request.count) result.spots.resize(request.count);
  return kStageDone;
}

Error SpotSearchJob::State::nothingFound() const {
  const PlacementRequest& place = request.placement;
  if (tooThin > 0)
    return {ErrorKind::NoSolution,
            message<"no-spot-wall-too-thin">(with::cause<"code">(codeInWords(place)), with::count<"count">(tooThin),
                                             with::lengthMm<"thickest">(thickestMm),
                                             with::lengthMm<"depth">(request.leastDepthMm),
                                             with::lengthMm<"wall">(request.minWallMm))};
  if (largest)
    return {ErrorKind::NoSolution,
            message<"no-spot-so-large">(with::cause<"code">(codeInWords(place)),
                                        with::lengthMm<"largest">(downToThreeDigits(largest->symbolMm)),
                                        with::place<"at">(largest->centreFileUnits),
                                        with::cause<"advice">(meetsCrossings ? message<"smaller-or-uncrossed">()
                                                                             : message<"smaller-or-scaled-up">()))};
  return {ErrorKind::NoSolution,
          message<"no-spot">(with::cause<"code">(codeInWords(place)),
                             with::lengthMm<"model">(boundingBox(model->prepared.mesh).diagonal()),
                             with::cause<"advice">(roomAdvice(
                                 model->prepared, {request.modules, outer}, place.eyeDistanceMm,
                                 meetsCrossings ? message<"uncross-or-shorten">() : message<"larger-or-flatter">())))};
}

double SpotSearchJob::State::testedShare() const {
  const std::size_t all = std::min(candidates.size(), mostTries());
  return std::max(static_cast<double>(goodSpots()) / static_cast<double>(request.count),
                  static_cast<double>(candidate) / static_cast<double>(std::max<std::size_t>(1, all)));
}

SpotSearchJob::SpotSearchJob(std::unique_ptr<State> state) : state_(std::move(state)) {}
SpotSearchJob::~SpotSearchJob() = default;

Result<std::unique_ptr<SpotSearchJob>> SpotSearchJob::create(std::shared_ptr<const EngravableModel> model,
                                                             const SpotSearchRequest& request) {
  QRELIEF_TRY(checkRequest(request));
  QRELIEF_TRY(model->prepared.engravable());
  const SizeBound room{request.modules, request.outerFactor()};
  QRELIEF_TRY(checkSizeBound(model->prepared, room, request.placement.eyeDistanceMm));
  if (wantedMm(request) < room.minSymbolMm())
    return tl::unexpected(
        tooSmallAsAsked({model->prepared, request.placement, request.modules, {}}, wantedMm(request)));

  auto state = std::make_unique<State>();
  state->outer = request.outerFactor();
  state->model = std::move(model);
  state->request = request;
  const PlacementRequest& placement = state->request.placement;
  state->startMap(state->fixed() ? placement.sizeMm * state->outer : unaskedLeastMm(*state->model));
  return std::unique_ptr<SpotSearchJob>(new SpotSearchJob(std::move(state)));
}

Progress SpotSearchJob::progress() const { return state_->stages.progress(); }

Result<Progress> SpotSearchJob::advance() { return state_->stages.advance(*state_); }

SpotSearchResult SpotSearchJob::takeResult() {
  assert(state_->stages.done());
  return std::move(state_->result);
}

SpotSearchRequest spotSearchFor(const EngraveRequest& request, const Symbol& symbol) {
  SpotSearchRequest search;
  search.placement = searchedPlacement(request, symbol.size);
  search.modules = symbol.size;
  search.minWallMm = request.depth.minWallMm;
  search.offersThinWalls = request.marking.isOpen;
  if (request.code.isText()) search.leastDepthMm = kLabelLayers * request.print.printer.layerMm;
  if (request.marking.mark == Mark::Inlay)
    search.leastDepthMm =
        kLeastInlayDepth * request.marking.markDepthMm.value_or(deepestInlayMm(request.print.printer));
  if (request.marking.mark == Mark::Paint) search.minWallMm = 0, search.leastDepthMm = kDepthQuantumMm;
  if (request.print.process) search.buildUp = request.print.buildUp;
  search.lamps = request.lamps();
  if (request.marking.isInColour()) search.coloured = colouredCodeOf(request);
  search.nozzleMm = request.print.printer.nozzleMm;
  search.leastPrintableMm = symbol.size * leastPrintableModuleMm(symbol, request);
  return search;
}

Result<SpotSearchResult> findSpots(std::shared_ptr<const EngravableModel> model, const SpotSearchRequest& request) {
  auto job = SpotSearchJob::create(std::move(model), request);
  QRELIEF_TRY(job);
  return runToEnd(**job);
}

}  // namespace qrelief
