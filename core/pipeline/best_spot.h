// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "base/progress.h"
#include "base/result.h"
#include "pipeline/spot_search.h"

namespace qrelief {

struct BestSpotOptions {
  double scaleToMm = 1;  ///< file units → mm, see SpotSearchRequest
  std::function<void(const Progress&)> tell = [](const Progress&) {};
};

/// Begins the search for the best spot for the code of a request: for its size if that is fixed, otherwise for the
/// largest code. The best spot is the first one of its result. Needs the model's GL context, if it has one.
/// @param request    its centre is ignored
/// @param scaleToMm  see SpotSearchRequest
/// @returns the errors of requestedSymbol(), checkEngraving() and SpotSearchJob
Result<std::unique_ptr<SpotSearchJob>> searchBestSpot(std::shared_ptr<const EngravableModel> model,
                                                      const EngraveRequest& request, double scaleToMm);

/// Runs searchBestSpot() to its end.
Result<Spot> bestSpot(std::shared_ptr<const EngravableModel> model, const EngraveRequest& request,
                      const BestSpotOptions& options = {});

/// Returns the placement with the spot's centre, and with its direction if the spot needs it.
PlacementRequest placedAt(const Spot& spot, PlacementRequest placement);

}  // namespace qrelief
