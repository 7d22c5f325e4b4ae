// SPDX-License-Identifier: GPL-3.0-or-later
// Implements how CarveJob (engrave.h) finds depths: by the search, or for codes in colour and text without one.
#include "base/clock.h"
#include "message_codes/pipeline.h"
#include "pipeline/engrave_state.h"
#include "pipeline/mark_depth.h"

namespace qrelief {

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

void CarveJob::State::startRecord(std::span<const double> limitMm) {
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    result.search.carved.push_back(static_cast<std::uint32_t>(i));
    result.search.limitMm.push_back(static_cast<float>(limitMm[i]));
  }
}

Result<StageStep> CarveJob::State::searchOnce() {
  const auto start = Clock::now();
  search->step(request.depth.recordSearch ? &result.search : nullptr);
  result.timingsMs.depthSearch += millisecondsSince(start);
  const DepthSearch& found = search->found();
  if (!found.finished()) return StageStep{found.doneFraction()};
  result.depths = found.depths();
  result.searchIterations += found.iterations();
  result.limitedSubmodules = found.limitedCount();
  result.unfinishedSubmodules = found.unfinishedCount();
  result.luminance = search->luminance();
  result.received = search->received();
  if (summarise(result.depths).maxMm == 0)
    return fail(ErrorKind::NoSolution,
                message<"nothing-can-be-carved">(with::lengthMm<"wall">(request.depth.minWallMm)));
  return kStageDone;
}

/// Chooses the modules to mark, and the depth of an inlay. Neither needs light.
Result<StageStep> CarveJob::State::mapMark() {
  const auto start = Clock::now();
  const Placement& placement = result.placement;
  mask = submodulesToCarve(symbol, ModulePattern::None, FinderPattern::None);
  marked = paintedModules(symbol, placement.symbolMm);
  result.depths = {marked.size, marked.symbolMm, std::vector<double>(marked.depthMm.size(), 0)};
  if (request.marking.mark == Mark::Inlay) QRELIEF_TRY(chooseInlay());
  result.timingsMs.surface = millisecondsSince(start);
  return kStageDone;
}

Status CarveJob::State::chooseInlay() {
  const Placement& placement = result.placement;
  if (!request.code.isText()) QRELIEF_TRY(measurePlace(false));
  result.opaqueDepthMm = inlayDepthMm(model->prepared.mesh, placement, request.print.buildUp.resolve(placement.frame),
                                      request.print.printer);
  const double wantedMm = request.marking.markDepthMm.value_or(result.opaqueDepthMm);
  if (request.code.isText()) {
    result.markDepthMm = wantedMm;  // labelPockets() leaves the walls
    return {};
  }
  const std::vector<double> limits =
      depthLimits(model->prepared.mesh, placement, mask, measured->thicknessMm(), {wantedMm, request.depth.minWallMm});
  InlayPockets pockets = inlayPockets(symbol, placement.symbolMm, limits, wantedMm);
  if (pockets.depthMm == 0)
    return fail(ErrorKind::NoSolution, message<"inlay-needs-walls">(with::lengthMm<"depth">(wantedMm),
                                                                    with::lengthMm<"wall">(request.depth.minWallMm)));
  result.markDepthMm = pockets.depthMm;
  result.modulesLeftOut = pockets.leftOut;
  marked = result.depths = std::move(pockets.depths);
  return {};
}

}  // namespace qrelief
