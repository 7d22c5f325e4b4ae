// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/depth_search_run.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "base/clock.h"
#include "depth/fast_search.h"
#include "depth/light_neighbours.h"
#include "depth/one_light_search.h"
#include "depth/paper_step_search.h"
#include "settings/engrave_request.h"

namespace qrelief {

namespace {

constexpr double kReachPerDepth = 8;  // at eight times its height away a wall hides 0.4 % of the sky
constexpr double kLeastReachModules = 3;

}  // namespace

DepthSearchRun::DepthSearchRun(const EngraveRequest& request, CarvingTarget target, Place place)
    : request_(request), target_(std::move(target)), place_(place) {
  for (std::uint32_t i = 0; i < target_.mask->size(); ++i)
    if ((*target_.mask)[i]) carved_.push_back(i);
}

Result<std::unique_ptr<DepthSearchRun>> DepthSearchRun::create(const EngraveRequest& request, CarvingTarget target,
                                                               Place place, const MakeSearch& makeOwnSearch) {
  std::unique_ptr<DepthSearchRun> search(new DepthSearchRun(request, std::move(target), place));
  if (makeOwnSearch) {
    search->solver_ = makeOwnSearch(search->target_);
  } else if (LuminancePass* const shaders = place.light->shaders();
             shaders && usesFastSearch(request) && request.lamps().empty()) {
    QRELIEF_TRY(search->startOnGpu(*shaders));
  } else {
    search->solver_ = makeDepthSolver(request, search->target_);
  }
  return search;
}

Status DepthSearchRun::startOnGpu(LuminancePass& light) {
  ShaderSearch::Place place;
  place.light = &light;
  for (const std::uint32_t i : carved_) place.cells.push_back(cellOf(i));
  place.luminance = ofQuietZone<double>(place_.light->uncarvedLuminance());
  light.setRadius(static_cast<float>(reachMm(*std::max_element(target_.limitMm.begin(), target_.limitMm.end()))));
  auto shaderSearch = ShaderSearch::create(target_, fastSearchOptions(request_), std::move(place));
  QRELIEF_TRY(shaderSearch);
  onGpu_ = std::move(*shaderSearch);
  return {};
}

void DepthSearchRun::restart(std::vector<double> contrastOfModule) {
  const FastSearchOptions options = fastSearchOptionsAfterPrint(request_, std::move(contrastOfModule));
  if (onGpu_)
    onGpu_->restart(options);
  else
    solver_ = std::make_unique<FastSearch>(target_, options, static_cast<const FastSearch*>(solver_.get()));
}

std::uint32_t DepthSearchRun::cellOf(std::uint32_t submodule) const {
  const int size = target_.mask->rows();
  return place_.layout.ofSymbol(static_cast<int>(submodule) / size, static_cast<int>(submodule) % size);
}

template <class Value, class Cells>
Grid<Value> DepthSearchRun::ofQuietZone(const Cells& cells) const {
  const int edge = CellLayout::kN * (place_.layout.modules + 2 * kQuietZoneModules);
  Grid<Value> picked(edge, edge);
  for (int row = 0; row < edge; ++row)
    for (int column = 0; column < edge; ++column)
      picked.at(row, column) = static_cast<Value>(cells[place_.layout.ofQuietZone(row, column)]);
  return picked;
}

/// Returns the distance beyond which only the uncarved surface's horizon counts.
double DepthSearchRun::reachMm(double deepestMm) const {
  return std::max(kLeastReachModules * place_.moduleMm, kReachPerDepth * deepestMm);
}

std::vector<float> DepthSearchRun::depthsOfCells() const {
  std::vector<float> cells(
      static_cast<std::size_t>(place_.layout.cells()) * static_cast<std::size_t>(place_.layout.cells()), 0.0f);
  for (const std::uint32_t i : carved_) cells[cellOf(i)] = static_cast<float>(found().depths().depthMm[i]);
  return cells;
}

/// Measures the luminance of the submodules that the solver requests, at its depths.
std::vector<float> DepthSearchRun::measured() {
  const std::span<const std::uint32_t> due = solver_->due().empty() ? carved_ : solver_->due();
  std::vector<std::uint32_t> cells;
  for (const std::uint32_t i : due) cells.push_back(cellOf(i));
  const std::vector<double>& depths = solver_->depths().depthMm;
  return place_.light->luminance(cells, depthsOfCells(), reachMm(*std::max_element(depths.begin(), depths.end())));
}

SearchRecord DepthSearchRun::startedRecord() const {
  SearchRecord record;
  record.carved = carved_;
  for (const std::uint32_t i : carved_) record.limitMm.push_back(static_cast<float>(target_.limitMm[i]));
  return record;
}

void DepthSearchRun::step(SearchRecord* record) {
  if (onGpu_) {
    stepOnGpu(record);
    return;
  }
  const auto start = Clock::now();
  luminance_ = ofQuietZone<double>(measured());
  const DepthField tried = record ? solver_->depths() : DepthField{};
  solver_->update(luminance_);
  if (!record) return;
  SearchRecord::Pass pass;
  pass.ms = millisecondsSince(start);
  for (const std::uint32_t i : carved_) {
    const int row = static_cast<int>(i) / tried.size, column = static_cast<int>(i) % tried.size;
    pass.depthMm.push_back(static_cast<float>(tried.depthMm[i]));
    pass.luminance.push_back(static_cast<float>(luminanceOf(luminance_, row, column)));
  }
  record->passes.push_back(std::move(pass));
  record->luminance = Grid<float>(luminance_);
}

void DepthSearchRun::stepOnGpu(SearchRecord* record) {
  const auto start = Clock::now();
  std::vector<SearchRecord::Pass> passes = onGpu_->advance();
  luminance_ = onGpu_->luminance();
  if (onGpu_->finished()) place_.light->shaders()->setDepths(depthsOfCells());  // for the inspector
  if (!record) return;
  const double ms = millisecondsSince(start) / static_cast<double>(passes.size());
  for (SearchRecord::Pass& pass : passes) {
    pass.ms = ms;
    record->passes.push_back(std::move(pass));
  }
  record->luminance = Grid<float>(luminance_);
}

Grid<Received> DepthSearchRun::received() const { return ofQuietZone<Received>(place_.light->received()); }

namespace {

constexpr double kDepthStepMm = 0.1;  // the published step; thicker layers need no coarser step
constexpr int kPassesBeforePrint = 4;
constexpr int kPassesUnderLamps = 60;  // depths grow little by little
/// Under lamps, a code for a print is carved darker than asked by this fraction, as shallower ones read less often
/// (docs/decisions/0052).
constexpr double kDarkerForPrint = 0.05;

double contrastUnderLamps(const EngraveRequest& request, double asked) {
  return request.isForPrint() ? 1 - (1 - asked) * (1 - kDarkerForPrint) : asked;
}

}  // namespace

bool usesFastSearch(const EngraveRequest& request) {
  return request.depth.objective == DepthObjective::Contrast && request.depth.solver == ContrastSolver::Fast;
}

FastSearchOptions fastSearchOptions(const EngraveRequest& request) {
  FastSearchOptions options;
  options.contrast = request.depth.contrastAsked();
  options.slackMm = std::min(request.print.printer.layerMm, kDepthStepMm) / 2;
  options.albedo = static_cast<float>(request.marking.surfaceAlbedo());
  options.hasLamps = !request.lamps().empty();
  if (options.hasLamps) {
    options.maxIterations = kPassesUnderLamps;
    options.contrast = contrastUnderLamps(request, options.contrast);
  } else if (request.isForPrint())
    options.maxIterations = kPassesBeforePrint;
  return options;
}

FastSearchOptions fastSearchOptionsAfterPrint(const EngraveRequest& request, std::vector<double> contrastOfModule) {
  assert(request.isForPrint());
  FastSearchOptions options = fastSearchOptions(request);
  if (options.hasLamps)
    for (double& contrast : contrastOfModule) contrast = contrastUnderLamps(request, contrast);
  else
    options.maxIterations = FastSearchOptions{}.maxIterations;
  options.contrastOfModule = std::move(contrastOfModule);
  return options;
}

std::unique_ptr<DepthSolver> makeDepthSolver(const EngraveRequest& request, CarvingTarget target) {
  if (request.depth.objective == DepthObjective::OneLight)
    return std::make_unique<OneLightSearch>(
        std::move(target), OneLightOptions{.lamp = request.lamps().front(), .contrast = request.depth.contrastAsked()});
  if (usesFastSearch(request)) return std::make_unique<FastSearch>(std::move(target), fastSearchOptions(request));
  DepthSearchOptions options;
  options.contrast = request.depth.contrastAsked();
  options.initialDepthMm = std::min(request.print.printer.layerMm, kDepthStepMm);
  return std::make_unique<PaperStepSearch>(std::move(target), options);
}

}  // namespace qrelief
