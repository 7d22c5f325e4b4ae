// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/engrave.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "base/clock.h"
#include "base/job_stages.h"
#include "mesh/weld.h"
#include "message_codes/pipeline.h"
#include "message_codes/stages.h"
#include "pipeline/add_inlay.h"
#include "pipeline/contrast_for_print.h"
#include "pipeline/engrave_stages.h"
#include "pipeline/label_pockets.h"
#include "pipeline/mark_depth.h"
#include "pipeline/placement_light.h"
#include "pipeline/printed_view.h"
#include "pipeline/requested_symbol.h"
#include "pipeline/shell_below.h"
#include "pipeline/spot_concerns.h"
#include "pipeline/verify.h"
#include "settings/settings.h"

namespace qrelief {

DepthSummary summarise(const DepthField& depths) {
  std::vector<double> carved;
  for (const double depth : depths.depthMm)
    if (depth > 0) carved.push_back(depth);
  if (carved.empty()) return {};
  std::sort(carved.begin(), carved.end());
  DepthSummary summary;
  for (const double depth : carved) summary.meanMm += depth / static_cast<double>(carved.size());
  summary.maxMm = carved.back();
  summary.p95Mm = carved[static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(carved.size()))) - 1];
  return summary;
}

DepthSummary pocketDepths(const EngraveResult& result) {
  if (!result.request.code.isText()) return summarise(result.depths);
  const double depthMm = result.request.marking.mark == Mark::Paint ? 0 : result.label.depthMm;
  return {depthMm, depthMm, depthMm};
}

CarvedFeatures featuresOf(const EngraveResult& result) {
  SubmoduleMask carved(result.depths.size, result.depths.size);
  for (std::size_t i = 0; i < carved.size(); ++i) carved[i] = result.depths.depthMm[i] > 0;
  CarvedFeatures features = measureFeatures(result.symbol, carved, result.depths.depthMm, result.placement.moduleMm);
  features.labelCapitalMm = capitalMmOf(result);
  return features;
}

Symbol markedSymbol(const EngraveResult& result) {
  Symbol marked = result.symbol;
  if (result.request.marking.mark != Mark::Inlay) return marked;
  for (int row = 0; row < marked.size; ++row)
    for (int column = 0; column < marked.size; ++column) {
      const bool isCarved = result.depths.depth(row * kSubmodulesPerModule, column * kSubmodulesPerModule) > 0;
      marked.dark.at(row, column) = isCarved;
    }
  return marked;
}

/// Values that pass from stage to stage.
struct CarveJob::State {
  JobStages<State> stages;
  std::shared_ptr<const EngravableModel> model;
  EngraveRequest asked;  // result.request: with open patterns filled in
  Known known;           // without placed and symbol
  std::optional<PlacementSearch> placing;
  std::shared_ptr<PlacementMeasurement> measured;
  SubmoduleMask mask;
  std::unique_ptr<DepthSearchRun> search;  // refers to mask, and to request and symbol of the result
  EmbedResult embedded;
  std::unique_ptr<PrintedViewJob> printing;
  EngraveResult result;  // from the start with symbol and request

  explicit State(JobStages<State> jobStages) : stages(std::move(jobStages)) {}

  /// Runs a step and adds up its time.
  template <Result<StageStep> (State::*kStep)(), double StageTimings::*kTime>
  Result<StageStep> timed() {
    const auto start = Clock::now();
    Result<StageStep> done = (this->*kStep)();
    result.timingsMs.*kTime += millisecondsSince(start);
    return done;
  }

  /// Returns the stages of a request. Weights are times in ms of the page's samples on a processor (--report,
  /// timingsMs).
  /// @param isPlaced  the placement is known
  static JobStages<State> stagesOf(const EngraveRequest& request, bool isPlaced) {
    using T = StageTimings;
    const bool isForPrint = request.isForPrint(), needsLight = request.needsLight();
    const auto searchOnce = &State::timed<&State::searchOnce, &T::depthSearch>;
    const auto embed = &State::timed<&State::embed, &T::embed>;
    return {{message<"finding-direction-and-size">(), 20, &State::place, !isPlaced},
            {message<"measuring-surface">(), 50, &State::timed<&State::mapLight, &T::surface>, needsLight},
            {message<"measuring-surface">(), 10, &State::timed<&State::mapMark, &T::surface>, !needsLight},
            {message<"finding-depth">(), 70, searchOnce, isForPrint},
            {message<"carving-mesh">(), 60, embed, isForPrint},
            {message<"printing">(), 300, &State::timed<&State::print, &T::forPrint>, isForPrint},
            {message<"finding-depth">(), 200, searchOnce, needsLight},
            {message<"carving-mesh">(), needsLight ? 60.0 : 4.0, embed},
            {message<"checking-solid">(), needsLight ? 10.0 : 4.0, &State::timed<&State::weld, &T::verify>},
            {message<"checking-solid">(), needsLight ? 250.0 : 20.0, &State::timed<&State::check, &T::verify>},
            {message<"looking-at-result">(), 250, &State::timed<&State::view, &T::verify>, !request.code.isText()}};
  }

  Result<StageStep> place() {
    const Result<bool> placed = placing->step();
    QRELIEF_TRY(placed);
    if (!*placed) return StageStep();
    take(placing->found());
    return kStageDone;
  }

  void take(const FoundPlacement& placed) {
    result.placement = placed.placement;
    result.timingsMs.direction = placed.directionMs;
    result.timingsMs.size = placed.sizeMs;
  }

  Status checkPlace() const {
    if (hasTwinSurface(model->prepared.mesh, result.placement))
      return fail(ErrorKind::NoSolution, message<"shell-in-same-place">());
    return {};
  }

  /// Measures the place, if it is not the one measured before.
  Status measurePlace(bool withLight) {
    const Placement& placement = result.placement;
    const auto albedo = static_cast<float>(asked.marking.surfaceAlbedo());
    const PlacementMeasurement::Request place{
        placement.frame, placement.moduleMm, {result.symbol.size}, albedo, asked.lamps(), known.device, withLight};
    const auto earlier = std::move(known.measured);
    if (earlier && earlier->request() == place) {
      if (withLight) earlier->light().uncarve();
      measured = earlier;
      return {};
    }
    auto measurement = PlacementMeasurement::create(model, known.programs, place);
    QRELIEF_TRY(measurement);
    measured = std::move(*measurement);
    return {};
  }

  Result<StageStep> mapLight() {
    QRELIEF_TRY(checkPlace());
    QRELIEF_TRY(measurePlace(true));
    const Placement& placement = result.placement;
    CarvableSubmodules carvable =
        carvableSubmodules(asked, result.symbol, model->prepared.mesh, placement, measured->thicknessMm());
    result.request = std::move(carvable.request);
    mask = std::move(carvable.mask);
    auto started =
        DepthSearchRun::create(result.request, {&result.symbol, &mask, placement.symbolMm, std::move(carvable.limitMm)},
                               {{result.symbol.size}, placement.moduleMm, &measured->light()}, known.makeSearch);
    QRELIEF_TRY(started);
    search = std::move(*started);
    if (asked.depth.recordSearch) result.search = search->startedRecord();
    return kStageDone;
  }

  /// Chooses the modules to mark, and the depth of an inlay. Neither needs light.
  Result<StageStep> mapMark() {
    QRELIEF_TRY(checkPlace());
    const Placement& placement = result.placement;
    const Mesh& mesh = model->prepared.mesh;
    result.depths = noPockets(result.symbol, placement.symbolMm);
    if (asked.marking.mark != Mark::Inlay) return kStageDone;
    result.opaqueDepthMm =
        inlayDepthMm(mesh, placement, asked.print.buildUp.resolve(placement.frame), asked.print.printer);
    result.markDepthMm = asked.marking.markDepthMm.value_or(result.opaqueDepthMm);
    if (asked.code.isText()) return kStageDone;  // labelPockets() leaves the walls
    QRELIEF_TRY(measurePlace(false));
    const DepthLimitOptions walls{result.markDepthMm, asked.depth.minWallMm};
    const SubmoduleMask wholeModules = submodulesToCarve(result.symbol, ModulePattern::None, FinderPattern::None);
    InlayPockets pockets =
        inlayPockets(result.symbol, placement.symbolMm,
                     depthLimits(mesh, placement, wholeModules, measured->thicknessMm(), walls), walls.maxDepthMm);
    if (pockets.depthMm == 0) {
      const auto depth = with::lengthMm<"depth">(walls.maxDepthMm);
      const auto wall = with::lengthMm<"wall">(walls.minWallMm);
      const auto below =
          model->prepared.shells < 2 ? std::nullopt : shellBelowMm(mesh, placement, walls.maxDepthMm + walls.minWallMm);
      if (!below) return fail(ErrorKind::NoSolution, message<"inlay-needs-walls">(depth, wall));
      return fail(ErrorKind::NoSolution,
                  message<"inlay-needs-walls-over-shell">(depth, wall, with::lengthMm<"below">(*below)));
    }
    result.markDepthMm = pockets.depthMm;
    result.modulesLeftOut = pockets.leftOut;
    result.depths = std::move(pockets.depths);
    return kStageDone;
  }

  Result<StageStep> searchOnce() {
    search->step(asked.depth.recordSearch ? &result.search : nullptr);
    const DepthSearch& found = search->found();
    if (!found.finished()) return StageStep{found.doneFraction()};
    result.depths = found.depths();
    result.searchIterations += found.iterations();
    result.limitedSubmodules = found.limitedCount();
    result.unfinishedSubmodules = found.unfinishedCount();
    result.luminance = search->luminance();
    result.received = search->received();
    const PreparedModel& prepared = model->prepared;
    const DepthRequest& depth = result.request.depth;
    if (prepared.shells > 1 && result.limitedSubmodules > result.unfinishedSubmodules)
      result.shellBelowMm = shellBelowMm(prepared.mesh, result.placement, *depth.maxDepthMm + depth.minWallMm);
    if (summarise(result.depths).maxMm > 0) return kStageDone;
    const auto wall = with::lengthMm<"wall">(depth.minWallMm);
    if (!result.shellBelowMm) return fail(ErrorKind::NoSolution, message<"nothing-can-be-carved">(wall));
    return fail(ErrorKind::NoSolution,
                message<"nothing-can-be-carved-over-shell">(wall, with::lengthMm<"below">(*result.shellBelowMm)));
  }

  Result<StageStep> embed() {
    const Mesh& mesh = model->prepared.mesh;
    const Placement& placement = result.placement;
    const Mark mark = asked.marking.mark;
    if (result.label.empty()) {
      auto label = labelPockets(result.request, mesh, placement, result.symbol.size, result.markDepthMm);
      QRELIEF_TRY(label);
      result.label = std::move(*label);
      if (asked.code.isText() && mark == Mark::Inlay) result.markDepthMm = result.label.depthMm;
    }
    auto embedding =
        embedDepthField(mesh, placement.frame, placement.patch.triangles,
                        mark == Mark::Paint ? paintedModules(result.symbol, placement.symbolMm) : result.depths,
                        {asked.surface(), mark == Mark::Inlay, mark == Mark::Paint, result.label});
    QRELIEF_TRY(embedding);
    embedded = std::move(*embedding);
    result.keptTriangles = embedded.keptTriangles;
    return kStageDone;
  }

  /// Simulates the print, a piece at a time, and starts a second search if the print lacks contrast.
  Result<StageStep> print() {
    if (!printing) {
      auto view = printedViewOf(verifyRequestOf(result.request, result));
      QRELIEF_TRY(view);
      (*view)->isRough = true;
      auto job = PrintedViewJob::create(embedded.mesh, **view);
      QRELIEF_TRY(job);
      printing = std::move(*job);
    }
    const auto progress = printing->advance();
    QRELIEF_TRY(progress);
    if (progress->done) {
      search->restart(contrastForPrint(result.symbol, result.luminance, printing->takeResult().submodules,
                                       result.request.depth.contrastAsked()));
      printing.reset();
      embedded = {};
    }
    return StageStep{progress->fraction, progress->done};
  }

  /// Makes the result: the mesh as a slicer reads its file, which holds positions bit for bit.
  Result<StageStep> weld() {
    const PreparedModel& before = model->prepared;
    result.mesh = weldedByPiece(embedded.mesh);
    result.origins = std::move(embedded.origins);
    result.bodies = before.bodies;
    result.carvedBody = before.mesh.body(result.placement.seed);
    result.coversColours = coversColours(before, result.placement,
                                         result.placement.symbolMm * roomFactor(result.symbol.size, asked.placement));
    result.painted = std::move(embedded.painted);
    return kStageDone;
  }

  Result<StageStep> check() {
    const auto solidity = checkCarved(result.mesh, result.origins, embedded.newTriangles, model->prepared);
    QRELIEF_TRY(solidity);
    result.solidity = *solidity;
    if (model->prepared.crossesItself) result.inheritedSelfIntersections = solidity->selfIntersections;
    if (asked.marking.mark == Mark::Inlay) QRELIEF_TRY(setInlay(embedded.inlay, result));
    embedded = {};
    return kStageDone;
  }

  Result<StageStep> view() {
    ReaderPicture picture = readerPicture(model->prepared.mesh, result);
    result.readerView = std::move(picture.view);
    result.readerOptions = std::move(picture.options);
    if (picture.luminance) result.luminance = std::move(*picture.luminance);
    return kStageDone;
  }
};

CarveJob::CarveJob(std::unique_ptr<State> state) : state_(std::move(state)) {}
CarveJob::~CarveJob() = default;

Result<std::unique_ptr<CarveJob>> CarveJob::create(std::shared_ptr<const EngravableModel> model,
                                                   EngraveRequest request) {
  return create(std::move(model), std::move(request), {});
}

Result<std::unique_ptr<CarveJob>> CarveJob::create(std::shared_ptr<const EngravableModel> model, EngraveRequest request,
                                                   const Known& known) {
  QRELIEF_TRY(checkSettings(request));
  auto symbol = known.symbol ? Result<Symbol>(*known.symbol) : requestedSymbol(request.code);
  QRELIEF_TRY(symbol);
  QRELIEF_TRY(checkEngraving(*model, request, *symbol));
  auto state = std::make_unique<State>(State::stagesOf(request, known.placed != nullptr));
  state->model = std::move(model);
  state->asked = state->result.request = std::move(request);
  state->known = known;
  state->known.placed = nullptr;
  state->known.symbol = nullptr;
  state->result.symbol = std::move(*symbol);
  state->result.litByShaders = state->model->usesShaders(known.device);
  assert(!known.makeSearch || !state->asked.isForPrint());
  const int modules = state->result.symbol.size;
  if (known.placed)
    state->take(*known.placed);
  else
    state->placing.emplace(state->model->prepared, *state->model->renderer, modules,
                           searchedPlacement(state->asked, modules));
  return std::unique_ptr<CarveJob>(new CarveJob(std::move(state)));
}

Progress CarveJob::progress() const { return state_->stages.progress(); }

Result<Progress> CarveJob::advance() { return state_->stages.advance(*state_); }

EngraveResult CarveJob::takeResult() {
  assert(state_->stages.done());
  return std::move(state_->result);
}

const EngraveResult* CarveJob::writtenResult() const {
  const bool isWritten = !state_->result.mesh.triangles.empty();
  return isWritten && !state_->stages.done() ? &state_->result : nullptr;
}

InspectorMaps CarveJob::inspectorMaps() const {
  const auto& measured = state_->measured;
  if (!measured || !measured->request().withLight) return {};
  return {&measured->light(), &state_->result.symbol, &state_->result.search};
}

const SurfaceMaps* CarveJob::surfaceMaps() const { return state_->measured ? state_->measured->maps() : nullptr; }

bool CarveJob::hasSearched() const { return state_->search && state_->search->found().finished(); }

std::optional<FoundPlacement> CarveJob::foundPlace() const {
  if (!state_->placing) return {};
  return state_->placing->found();
}

std::shared_ptr<PlacementMeasurement> CarveJob::placementMeasurement() const { return state_->measured; }

Result<EngraveResult> engrave(std::shared_ptr<const EngravableModel> model, const EngraveRequest& request) {
  auto job = CarveJob::create(std::move(model), request);
  QRELIEF_TRY(job);
  return runToEnd(**job);
}

}  // namespace qrelief
