// SPDX-License-Identifier: GPL-3.0-or-later
// Implements what EngraveJob (engrave.h) does for codes in colour and for text in place of a depth search.
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

/// Chooses the modules to mark, and the depth of an inlay. Neither needs light.
Result<StageStep> EngraveJob::State::mapMark() {
  const auto start = Clock::now();
  const Placement& placement = result.placement;
  mask = submodulesToCarve(symbol, ModulePattern::None, FinderPattern::None);
  marked = paintedModules(symbol, placement.symbolMm);
  result.depths = {marked.size, marked.symbolMm, std::vector<double>(marked.depthMm.size(), 0)};
  if (request.marking.mark == Mark::Inlay) QRELIEF_TRY(chooseInlay());
  result.timingsMs.surface = millisecondsSince(start);
  return kStageDone;
}

Status EngraveJob::State::chooseInlay() {
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
