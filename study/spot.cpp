// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/spot.h"

#include "depth/wall_limit.h"
#include "pipeline/placement.h"

namespace qrelief::study {

std::vector<double> StudyPlacement::limitsMm(const SubmoduleMask& mask, double maxDepthMm) const {
  return wallLimits(model->prepared.mesh, placement.patch, placement.frame, mask,
                    {placement.symbolMm, maxDepthMm, request.depth.minWallMm});
}

Result<StudyPlacement> findSpot(std::string name, std::shared_ptr<const EngravableModel> model,
                                const EngraveRequest& request) {
  auto symbol = encodeSymbol(request.code.text, request.code.symbol);
  QRELIEF_TRY(symbol);
  auto pass = GeometryPass::create();
  QRELIEF_TRY(pass);
  StudyPlacement spot{std::move(name), std::move(model), request, {}, std::move(*symbol), {}, {}};
  spot.pass = std::make_shared<const GeometryPass>(std::move(*pass));
  const int modules = spot.symbol.size;
  PlacementSearch search(spot.model->prepared, *spot.model->renderer, modules, searchedPlacement(request, modules));
  for (;;) {
    const auto done = search.step();
    QRELIEF_TRY(done);
    if (*done) break;
  }
  spot.placement = search.placement();
  return spot;
}

}  // namespace qrelief::study
