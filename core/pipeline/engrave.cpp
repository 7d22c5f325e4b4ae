// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/engrave.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "base/clock.h"
#include "message_codes/stages.h"
#include "pipeline/contrast_for_print.h"
#include "pipeline/default_patterns.h"
#include "pipeline/engrave_state.h"
#include "pipeline/label_pockets.h"
#include "pipeline/requested_symbol.h"
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

/// Weights are times in ms of the page's samples on a processor (--report, timingsMs).
JobStages<CarveJob::State> CarveJob::State::stagesOf(const EngraveRequest& request, bool isPlaced) {
  const bool isForPrint = request.isForPrint(), needsLight = request.needsLight();
  return {{message<"finding-direction-and-size">(), 20, &State::place, !isPlaced},
          {message<"measuring-surface">(), 50, &State::map, needsLight},
          {message<"measuring-surface">(), 10, &State::mapMark, !needsLight},
          {message<"finding-depth">(), 70, &State::searchOnce, isForPrint},
          {message<"carving-mesh">(), 60, &State::embed, isForPrint},
          {message<"printing">(), 300, &State::print, isForPrint},
          {message<"finding-depth">(), 200, &State::searchOnce, needsLight},
          {message<"carving-mesh">(), needsLight ? 60.0 : 4.0, &State::embed},
          {message<"checking-solid">(), needsLight ? 10.0 : 4.0, &State::weld},
          {message<"checking-solid">(), needsLight ? 250.0 : 20.0, &State::check},
          {message<"looking-at-result">(), 250, &State::view, !request.code.isText()}};
}

Result<StageStep> CarveJob::State::place() {
  const Result<bool> placed = placing->step();
  QRELIEF_TRY(placed);
  if (!*placed) return StageStep();
  take(placing->found());
  return kStageDone;
}

void CarveJob::State::take(const FoundPlacement& placed) {
  result.placement = placed.placement;
  result.timingsMs.direction = placed.directionMs;
  result.timingsMs.size = placed.sizeMs;
  asked = request;
  if (request.needsLight()) decidePatterns(false);
}

void CarveJob::State::decidePatterns(bool areWallsThin) {
  request = withDefaultPatterns(asked, result.placement.moduleMm, areWallsThin);
  mask = submodulesToCarve(symbol, request.code.modules(), *request.code.finderPattern);
}

std::vector<double> CarveJob::State::limitsOfMask() const {
  return depthLimits(model->prepared.mesh, result.placement, mask, measured->thicknessMm(),
                     {*request.depth.maxDepthMm, request.depth.minWallMm});
}

/// Measures the place, if it is not the one measured before.
Status CarveJob::State::measurePlace(bool withLight) {
  const Placement& placement = result.placement;
  const PlacementMeasurement::Request place{
      placement.frame, placement.moduleMm, layout, request.depth.albedo, request.lamps(), device, withLight};
  if (measured && measured->request() == place) {
    if (withLight) measured->light().uncarve();
  } else {
    auto measurement = PlacementMeasurement::create(model, programs, place);
    QRELIEF_TRY(measurement);
    measured = std::move(*measurement);
  }
  isMeasured = true;
  return {};
}

Result<StageStep> CarveJob::State::map() {
  const auto start = Clock::now();
  const Placement& placement = result.placement;
  QRELIEF_TRY(measurePlace(true));
  std::vector<double> limits = limitsOfMask();
  if (!asked.code.finderPattern && request.code.finderPattern == FinderPattern::None &&
      wallsAreThinForWholeFinders(symbol, limits, placement.moduleMm)) {
    decidePatterns(true);
    limits = limitsOfMask();
  }
  if (request.depth.recordSearch) startRecord(limits);
  target = {&symbol, &mask, placement.symbolMm, std::move(limits)};
  auto started =
      DepthSearchRun::create(request, target, {layout, placement.moduleMm, &measured->light()}, makeOwnSearch);
  QRELIEF_TRY(started);
  search = std::move(*started);
  result.timingsMs.surface = millisecondsSince(start);
  return kStageDone;
}

Result<StageStep> CarveJob::State::embed() {
  const auto start = Clock::now();
  EmbedOptions options;
  options.inlay = request.marking.mark == Mark::Inlay;
  options.paint = request.marking.mark == Mark::Paint;
  if (result.label.empty()) {
    auto label = labelPockets(request, model->prepared.mesh, result.placement, symbol.size, result.markDepthMm);
    QRELIEF_TRY(label);
    result.label = std::move(*label);
    if (request.code.isText() && options.inlay) result.markDepthMm = result.label.depthMm;
  }
  options.surface = request.surface();
  options.label = result.label;
  auto embedding = embedDepthField(model->prepared.mesh, result.placement.frame, result.placement.patch.triangles,
                                   request.needsLight() ? result.depths : marked, options);
  QRELIEF_TRY(embedding);
  embedded = std::move(*embedding);
  result.keptTriangles = embedded.keptTriangles;
  result.timingsMs.embed += millisecondsSince(start);
  return kStageDone;
}

/// Simulates the print, a piece at a time, and starts a second search if the print lacks contrast.
Result<StageStep> CarveJob::State::print() {
  const auto start = Clock::now();
  if (!printing) {
    VerifyRequest printed = verifyRequestOf(request, result);
    printed.symbol = symbol;
    auto view = printedViewOf(printed);
    QRELIEF_TRY(view);
    (*view)->isRough = true;
    auto job = PrintedViewJob::create(embedded.mesh, **view);
    QRELIEF_TRY(job);
    printing = std::move(*job);
  }
  const auto progress = printing->advance();
  QRELIEF_TRY(progress);
  if (progress->done) {
    search->restart(
        contrastForPrint(symbol, result.luminance, printing->takeResult().submodules, request.depth.contrastAsked()));
    printing.reset();
    embedded = {};
  }
  result.timingsMs.forPrint += millisecondsSince(start);
  return StageStep{progress->fraction, progress->done};
}

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
  state->request = std::move(request);
  state->programs = known.programs;
  state->symbol = std::move(*symbol);
  state->layout = {state->symbol.size};
  state->measured = known.measured;
  state->device = known.device;
  state->result.litByShaders = state->model->usesShaders(known.device);
  state->makeOwnSearch = known.makeSearch;
  assert(!state->makeOwnSearch || !state->request.isForPrint());
  if (known.placed)
    state->take(*known.placed);
  else
    state->placing.emplace(state->model->prepared, *state->model->renderer, state->symbol.size,
                           searchedPlacement(state->request, state->symbol.size));
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
  InspectorMaps maps;
  if (!state_->isMeasured || !state_->measured->request().withLight) return maps;
  const PlacementMeasurement& measured = *state_->measured;
  maps.light = &measured.light();
  maps.symbol = &state_->symbol;
  maps.search = &state_->result.search;
  return maps;
}

const SurfaceMaps* CarveJob::surfaceMaps() const { return state_->isMeasured ? state_->measured->maps() : nullptr; }

bool CarveJob::hasSearched() const { return state_->search && state_->search->found().finished(); }

std::optional<FoundPlacement> CarveJob::foundPlace() const {
  if (!state_->placing) return {};
  return state_->placing->found();
}

std::shared_ptr<PlacementMeasurement> CarveJob::placementMeasurement() const {
  return state_->isMeasured ? state_->measured : nullptr;
}

Result<EngraveResult> engrave(std::shared_ptr<const EngravableModel> model, const EngraveRequest& request) {
  auto job = CarveJob::create(std::move(model), request);
  QRELIEF_TRY(job);
  return runToEnd(**job);
}

}  // namespace qrelief
