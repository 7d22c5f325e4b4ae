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
#include "pipeline/depth_limits.h"
#include "pipeline/engrave_state.h"
#include "pipeline/label_pockets.h"
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

CarvedFeatures featuresOf(const EngraveResult& result) {
  std::vector<std::uint8_t> carved;
  for (const double depth : result.depths.depthMm) carved.push_back(depth > 0);
  CarvedFeatures features = measureFeatures(result.symbol, carved, result.depths.depthMm, result.placement.moduleMm);
  features.labelCapitalMm = labelCapitalMm(result.request.code.label, result.symbol.size, result.placement.moduleMm);
  return features;
}

/// Weights are times in ms of the page's samples on a processor (--report, timingsMs).
JobStages<EngraveJob::State> EngraveJob::State::stagesOf(const EngraveRequest& request, bool isPlaced) {
  const bool isForPrint = request.isForPrint(), isInColour = request.marking.isInColour();
  return {{message<"finding-direction-and-size">(), 20, &State::place, !isPlaced},
          {message<"measuring-surface">(), 50, &State::map, !isInColour},
          {message<"measuring-surface">(), 10, &State::mapMark, isInColour},
          {message<"finding-depth">(), 70, &State::searchOnce, isForPrint},
          {message<"carving-mesh">(), 60, &State::embed, isForPrint},
          {message<"printing">(), 300, &State::print, isForPrint},
          {message<"finding-depth">(), 200, &State::searchOnce, !isInColour},
          {message<"carving-mesh">(), isInColour ? 4.0 : 60.0, &State::embed},
          {message<"checking-solid">(), isInColour ? 4.0 : 10.0, &State::write},
          {message<"checking-solid">(), isInColour ? 20.0 : 250.0, &State::check},
          {message<"looking-at-result">(), 250, &State::view}};
}

Result<StageStep> EngraveJob::State::place() {
  const Result<bool> placed = placing->step();
  if (!placed) return tl::unexpected(placed.error());
  if (!*placed) return StageStep();
  take(*placing);
  return kStageDone;
}

void EngraveJob::State::take(const PlacementSearch& placed) {
  result.placement = placed.placement();
  result.timingsMs.direction = placed.directionMs();
  result.timingsMs.size = placed.sizeMs();
  asked = request;
  if (!request.marking.isInColour()) decidePatterns(false);
}

void EngraveJob::State::decidePatterns(bool areWallsThin) {
  request = withDefaultPatterns(asked, result.placement.moduleMm, areWallsThin);
  mask = submodulesToCarve(symbol, *request.code.modulePattern, *request.code.finderPattern);
}

std::vector<double> EngraveJob::State::limitsOfMask() const {
  return depthLimits(model->prepared.mesh, result.placement, mask, measured->thicknessMm(),
                     {*request.depth.maxDepthMm, request.depth.minWallMm});
}

/// Measures the place, if it is not the one measured before.
Status EngraveJob::State::measurePlace(bool withLight) {
  const Placement& placement = result.placement;
  const PlacementMeasurement::Request place{
      placement.frame, placement.moduleMm, layout, request.depth.albedo, request.lamps(), device, withLight};
  if (measured && measured->request() == place) {
    if (withLight) measured->light().uncarve();
  } else {
    auto measurement = PlacementMeasurement::create(model, programs, place);
    if (!measurement) return tl::unexpected(measurement.error());
    measured = std::move(*measurement);
  }
  isMeasured = true;
  return {};
}

Result<StageStep> EngraveJob::State::map() {
  const auto start = Clock::now();
  const Placement& placement = result.placement;
  if (const Status known = measurePlace(true); !known) return tl::unexpected(known.error());
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
  if (!started) return tl::unexpected(started.error());
  search = std::move(*started);
  result.timingsMs.surface = millisecondsSince(start);
  return kStageDone;
}

Result<StageStep> EngraveJob::State::embed() {
  const auto start = Clock::now();
  if (result.label.empty()) {
    auto label = labelPockets(request, model->prepared.mesh, result.placement, symbol.size, result.markDepthMm);
    if (!label) return tl::unexpected(label.error());
    result.label = std::move(*label);
  }
  EmbedOptions options;
  options.inlay = request.marking.mark == Mark::Inlay;
  options.paint = request.marking.mark == Mark::Paint;
  if (!request.marking.isInColour()) options.surface = request.depth.surface;
  options.label = result.label;
  auto embedding = embedDepthField(model->prepared.mesh, result.placement.frame, result.placement.patch.triangles,
                                   request.marking.isInColour() ? marked : result.depths, options);
  if (!embedding) return tl::unexpected(embedding.error());
  embedded = std::move(*embedding);
  result.keptTriangles = embedded.keptTriangles;
  result.timingsMs.embed += millisecondsSince(start);
  return kStageDone;
}

/// Simulates the print, a piece at a time, and starts a second search if the print lacks contrast.
Result<StageStep> EngraveJob::State::print() {
  const auto start = Clock::now();
  if (!printing) {
    VerifyRequest printed = verifyRequestOf(request, result);
    printed.symbol = symbol;
    auto view = printedViewOf(printed);
    if (!view) return tl::unexpected(view.error());
    (*view)->isRough = true;
    auto job = PrintedViewJob::create(embedded.mesh, **view);
    if (!job) return tl::unexpected(job.error());
    printing = std::move(*job);
  }
  const auto progress = printing->advance();
  if (!progress) return tl::unexpected(progress.error());
  if (progress->done) {
    search->restart(
        contrastForPrint(symbol, result.luminance, printing->takeResult().submodules, request.depth.contrastAsked()));
    printing.reset();
    embedded = {};
  }
  result.timingsMs.forPrint += millisecondsSince(start);
  return StageStep{progress->fraction, progress->done};
}

EngraveJob::EngraveJob(std::unique_ptr<State> state) : state_(std::move(state)) {}
EngraveJob::~EngraveJob() = default;

Result<std::unique_ptr<EngraveJob>> EngraveJob::create(std::shared_ptr<const EngravableModel> model,
                                                       EngraveRequest request) {
  return create(std::move(model), std::move(request), {});
}

Result<std::unique_ptr<EngraveJob>> EngraveJob::create(std::shared_ptr<const EngravableModel> model,
                                                       EngraveRequest request, const Known& known) {
  if (const Status checked = checkSettings(request); !checked) return tl::unexpected(checked.error());
  auto symbol = known.symbol ? Result<Symbol>(*known.symbol) : encodeSymbol(request.code.text, request.code.symbol);
  if (!symbol) return tl::unexpected(symbol.error());
  if (const Status good = checkEngraving(*model, request, *symbol); !good) return tl::unexpected(good.error());
  auto state = std::make_unique<State>(State::stagesOf(request, known.placed != nullptr));
  state->model = std::move(model);
  state->request = std::move(request);
  state->programs = known.programs;
  state->symbol = std::move(*symbol);
  state->layout = {state->symbol.size};
  state->measured = known.measured;
  state->device = known.device;
  state->makeOwnSearch = known.makeSearch;
  assert(!state->makeOwnSearch || !state->request.isForPrint());
  if (known.placed)
    state->take(*known.placed);
  else
    state->placing.emplace(state->model->prepared, *state->model->renderer, state->symbol.size,
                           searchedPlacement(state->request, state->symbol.size));
  return std::unique_ptr<EngraveJob>(new EngraveJob(std::move(state)));
}

Progress EngraveJob::progress() const { return state_->stages.progress(); }

Result<Progress> EngraveJob::advance() { return state_->stages.advance(*state_); }

EngraveResult EngraveJob::takeResult() {
  assert(state_->stages.done());
  return std::move(state_->result);
}

const EngraveResult* EngraveJob::writtenResult() const {
  const bool isWritten = !state_->result.stl.empty();
  return isWritten && !state_->stages.done() ? &state_->result : nullptr;
}

InspectorMaps EngraveJob::inspectorMaps() const {
  InspectorMaps maps;
  if (!state_->isMeasured || !state_->measured->request().withLight) return maps;
  const PlacementMeasurement& measured = *state_->measured;
  maps.light = &measured.light();
  maps.symbol = &state_->symbol;
  maps.search = &state_->result.search;
  return maps;
}

const SurfaceMaps* EngraveJob::surfaceMaps() const { return state_->isMeasured ? state_->measured->maps() : nullptr; }

std::shared_ptr<PlacementMeasurement> EngraveJob::placementMeasurement() const {
  return state_->isMeasured ? state_->measured : nullptr;
}

Result<EngraveResult> engrave(std::shared_ptr<const EngravableModel> model, const EngraveRequest& request) {
  auto job = EngraveJob::create(std::move(model), request);
  if (!job) return tl::unexpected(job.error());
  return runToEnd(**job);
}

}  // namespace qrelief
