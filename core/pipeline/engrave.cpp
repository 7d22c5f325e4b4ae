// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/engrave.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "base/clock.h"
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

Progress EngraveJob::State::progress() {
  auto [doing, share] = [&]() -> std::pair<Message, double> {
    switch (stage) {
      case Stage::Placing:
        return {message("finding-direction-and-size"), 0.05};
      case Stage::Mapping:
        return {message("measuring-surface"), 0.15};
      case Stage::Searching: {
        const double done = search->doneFraction();
        if (!request.isForPrint()) return {message("finding-depth"), 0.25 + 0.45 * done};
        return {message("finding-depth"), isPrinted ? 0.55 + 0.15 * done : 0.25 + 0.15 * done};
      }
      case Stage::Printing:
        return {message("printing"), 0.45};
      case Stage::Embedding:
        return {message("carving-mesh"), request.isForPrint() && !isPrinted ? 0.4 : 0.7};
      case Stage::Writing:
      case Stage::Checking:
        return {message("checking-solid"), 0.8};
      case Stage::Viewing:
      case Stage::Done:
        break;
    }
    return {message("looking-at-result"), stage == Stage::Done ? 1 : 0.9};
  }();
  fraction = std::max(fraction, share);
  return {std::move(doing), fraction, stage == Stage::Done};
}

Status EngraveJob::State::place() {
  const Result<bool> placed = placing->step();
  if (!placed) return tl::unexpected(placed.error());
  if (*placed) take(*placing);
  return {};
}

void EngraveJob::State::take(const PlacementSearch& found) {
  result.placement = found.placement();
  result.timingsMs.direction = found.directionMs();
  result.timingsMs.size = found.sizeMs();
  asked = request;
  if (!request.marking.isInColour()) decidePatterns(false);
  stage = Stage::Mapping;
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
  const PlacementMeasurement::Request wanted{
      placement.frame, placement.moduleMm, layout, request.depth.albedo, request.lamps(), device, withLight};
  if (measured && measured->request() == wanted) {
    if (withLight) measured->light().uncarve();
  } else {
    auto made = PlacementMeasurement::create(model, programs, wanted);
    if (!made) return tl::unexpected(made.error());
    measured = std::move(*made);
  }
  isMeasured = true;
  return {};
}

Status EngraveJob::State::map() {
  const auto start = Clock::now();
  const Placement& placement = result.placement;
  if (const Status known = measurePlace(true); !known) return known;
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
  stage = Stage::Searching;
  return {};
}

Status EngraveJob::State::embed() {
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
  auto made = embedDepthField(model->prepared.mesh, result.placement.frame, result.placement.patch.triangles,
                              request.marking.isInColour() ? marked : result.depths, options);
  if (!made) return tl::unexpected(made.error());
  embedded = std::move(*made);
  result.keptTriangles = embedded.keptTriangles;
  result.timingsMs.embed += millisecondsSince(start);
  stage = request.isForPrint() && !isPrinted ? Stage::Printing : Stage::Writing;
  return {};
}

/// Simulates the print, a piece at a time, and starts a second search if the print lacks contrast.
Status EngraveJob::State::print() {
  const auto start = Clock::now();
  if (!printing) {
    VerifyRequest printed = verifyRequestOf(request, result);
    printed.symbol = symbol;
    auto wanted = printedViewOf(printed);
    if (!wanted) return tl::unexpected(wanted.error());
    (*wanted)->isRough = true;
    auto job = PrintedViewJob::create(embedded.mesh, **wanted);
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
    isPrinted = true;
    stage = Stage::Searching;
  }
  result.timingsMs.forPrint += millisecondsSince(start);
  return {};
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
  auto state = std::make_unique<State>();
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

Progress EngraveJob::progress() const { return state_->progress(); }

Result<Progress> EngraveJob::advance() {
  using Stage = State::Stage;
  State& s = *state_;
  Status done;
  switch (s.stage) {
    case Stage::Placing:
      done = s.place();
      break;
    case Stage::Mapping:
      done = s.request.marking.isInColour() ? s.mapMark() : s.map();
      break;
    case Stage::Searching:
      done = s.searchOnce();
      break;
    case Stage::Embedding:
      done = s.embed();
      break;
    case Stage::Printing:
      done = s.print();
      break;
    case Stage::Writing:
      done = s.write();
      break;
    case Stage::Checking:
      done = s.check();
      break;
    case Stage::Viewing:
      s.view();
      break;
    case Stage::Done:
      assert(false && "advance() after done");
      break;
  }
  if (!done) return tl::unexpected(done.error());
  return s.progress();
}

EngraveResult EngraveJob::takeResult() {
  assert(state_->stage == State::Stage::Done);
  return std::move(state_->result);
}

const EngraveResult* EngraveJob::writtenResult() const {
  using Stage = State::Stage;
  const bool isWritten = state_->stage == Stage::Checking || state_->stage == Stage::Viewing;
  return isWritten ? &state_->result : nullptr;
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
