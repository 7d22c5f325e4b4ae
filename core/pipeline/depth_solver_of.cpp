// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/depth_solver_of.h"

#include <algorithm>

#include "depth/depth_search.h"
#include "depth/fast_search.h"
#include "depth/one_light_search.h"
#include "depth/reading_search.h"
#include "depth/shaped_floor_search.h"

namespace qrelief {
namespace {

constexpr double kDepthStepMm = 0.1;  // the published step; thicker layers need no coarser step
constexpr int kPassesBeforePrint = 4;

}  // namespace

std::unique_ptr<DepthSolver> makeDepthSolver(const EngraveRequest& request, CarvingTarget target,
                                             std::vector<double> contrastOfModule, const DepthSolver* before) {
  if (request.objective == DepthObjective::Reading)
    return std::make_unique<ReadingSearch>(std::move(target), request.reading);
  if (request.objective == DepthObjective::OneLight)
    return std::make_unique<OneLightSearch>(
        std::move(target), OneLightOptions{.lamp = request.lamps().front(), .contrast = request.contrastAsked()});
  const double slackMm = std::min(request.printer.layerMm, kDepthStepMm) / 2;
  if (request.floor != FloorShape::Flat)
    return std::make_unique<ShapedFloorSearch>(
        std::move(target),
        ShapedFloorOptions{.shape = request.floor, .contrast = request.contrastAsked(), .slackMm = slackMm});
  if (request.solver == ContrastSolver::PaperSteps) {
    DepthSearchOptions options;
    options.contrast = request.contrastAsked();
    options.initialDepthMm = std::min(request.printer.layerMm, kDepthStepMm);
    return std::make_unique<DepthSearch>(std::move(target), options);
  }
  FastSearchOptions options;
  options.contrast = request.contrastAsked();
  options.contrastOfModule = std::move(contrastOfModule);
  options.slackMm = slackMm;
  options.albedo = static_cast<double>(request.albedo);
  const bool isBeforePrint = request.isForPrint() && options.contrastOfModule.empty();
  if (isBeforePrint) options.maxIterations = kPassesBeforePrint;
  return std::make_unique<FastSearch>(std::move(target), options, dynamic_cast<const FastSearch*>(before));
}

}  // namespace qrelief
