// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/by_engine.h"

#include "depth/light_neighbours.h"

namespace qrelief::study {

EngraveRequest publishedRequest(const StudyPlacement& spot, ModulePattern modules, FinderPattern finders) {
  EngraveRequest request = spot.request;
  request.depth.solver = ContrastSolver::PaperSteps;
  request.code.modulePattern = modules;
  request.code.finderPattern = finders;
  request.depth.maxDepthMm = kPublishedMaxDepthModules * spot.placement.moduleMm;
  return request;
}

Result<CarvedCode> carveByEngine(const StudyPlacement& spot, const EngraveRequest& request, const Symbol* symbol,
                                 MakeSearch makeSearch) {
  const FoundPlacement placed{spot.placement};
  CarveJob::Known known{&placed, nullptr, symbol, spot.measured};
  known.makeSearch = std::move(makeSearch);
  auto job = CarveJob::create(spot.model, request, known);
  QRELIEF_TRY(job);
  auto result = runToEnd(**job);
  QRELIEF_TRY(result);
  spot.measured = (*job)->placementMeasurement();
  CarvedCode code;
  code.mask =
      submodulesToCarve(result->symbol, *result->request.code.modulePattern, *result->request.code.finderPattern);
  code.symbol = std::move(result->symbol);
  for (const std::uint32_t i : carvedOf(code.mask))
    code.ownEstimate.push_back(
        luminanceOf(result->luminance, static_cast<int>(i) / code.mask.rows(), static_cast<int>(i) % code.mask.rows()));
  code.depths = std::move(result->depths);
  if (request.depth.objective == DepthObjective::OneLight) code.readUnder = request.lamps().front();
  code.passes = result->searchIterations;
  code.limited = result->limitedSubmodules;
  code.milliseconds = result->timingsMs.surface + result->timingsMs.depthSearch + result->timingsMs.forPrint;
  return code;
}

}  // namespace qrelief::study
