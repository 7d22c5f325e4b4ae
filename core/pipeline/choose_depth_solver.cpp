// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/choose_depth_solver.h"

#include <algorithm>
#include <cassert>

#include "depth/one_light_search.h"
#include "depth/paper_step_search.h"
#include "settings/engrave_request.h"

namespace qrelief {
namespace {

constexpr double kDepthStepMm = 0.1;  // the published step; thicker layers need no coarser step
constexpr int kPassesBeforePrint = 4;
constexpr int kPassesUnderLamps = 40;  // depths grow little by little

}  // namespace

bool usesFastSearch(const EngraveRequest& request) {
  return request.depth.objective == DepthObjective::Contrast && request.depth.solver == ContrastSolver::Fast;
}

FastSearchOptions fastSearchOptions(const EngraveRequest& request) {
  FastSearchOptions options;
  options.contrast = request.depth.contrastAsked();
  options.slackMm = std::min(request.print.printer.layerMm, kDepthStepMm) / 2;
  options.albedo = static_cast<double>(request.depth.albedo);
  options.hasLamps = !request.lamps().empty();
  if (options.hasLamps) options.maxIterations = kPassesUnderLamps;
  if (request.isForPrint()) options.maxIterations = kPassesBeforePrint;
  return options;
}

FastSearchOptions fastSearchOptionsAfterPrint(const EngraveRequest& request, std::vector<double> contrastOfModule) {
  assert(request.isForPrint());
  FastSearchOptions options = fastSearchOptions(request);
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
