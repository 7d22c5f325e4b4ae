// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/depth_solver_of.h"

#include <algorithm>
#include <cassert>

#include "depth/depth_search.h"
#include "depth/one_light_search.h"

namespace qrelief {
namespace {

constexpr double kDepthStepMm = 0.1;  // the published step; thicker layers need no coarser step
constexpr int kPassesBeforePrint = 4;

FastSearchOptions fastOptions(const EngraveRequest& request) {
  FastSearchOptions options;
  options.contrast = request.depth.contrastAsked();
  options.slackMm = std::min(request.print.printer.layerMm, kDepthStepMm) / 2;
  options.albedo = static_cast<double>(request.depth.albedo);
  return options;
}

}  // namespace

std::unique_ptr<DepthSolver> makeDepthSolver(const EngraveRequest& request, CarvingTarget target) {
  if (request.depth.objective == DepthObjective::OneLight)
    return std::make_unique<OneLightSearch>(
        std::move(target), OneLightOptions{.lamp = request.lamps().front(), .contrast = request.depth.contrastAsked()});
  if (request.depth.solver == ContrastSolver::Fast)
    return std::make_unique<FastSearch>(std::move(target), fastOptions(request));
  DepthSearchOptions options;
  options.contrast = request.depth.contrastAsked();
  options.initialDepthMm = std::min(request.print.printer.layerMm, kDepthStepMm);
  return std::make_unique<DepthSearch>(std::move(target), options);
}

std::unique_ptr<FastSearch> makeSearchBeforePrint(const EngraveRequest& request, CarvingTarget target) {
  assert(request.isForPrint());
  FastSearchOptions options = fastOptions(request);
  options.maxIterations = kPassesBeforePrint;
  return std::make_unique<FastSearch>(std::move(target), options);
}

std::unique_ptr<FastSearch> makeSearchAfterPrint(const EngraveRequest& request, CarvingTarget target,
                                                 std::vector<double> contrastOfModule, const FastSearch& before) {
  assert(request.isForPrint());
  FastSearchOptions options = fastOptions(request);
  options.contrastOfModule = std::move(contrastOfModule);
  return std::make_unique<FastSearch>(std::move(target), options, &before);
}

}  // namespace qrelief
