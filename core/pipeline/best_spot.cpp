// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/best_spot.h"

#include <utility>

#include "pipeline/requested_symbol.h"

namespace qrelief {
namespace {

/// Spots to find. The search ranks spots by print and light only once it has found them, so the best of three may be
/// better than the first.
constexpr std::size_t kSpots = 3;

}  // namespace

Result<std::unique_ptr<SpotSearchJob>> searchBestSpot(std::shared_ptr<const EngravableModel> model,
                                                      const EngraveRequest& request, double scaleToMm) {
  const auto symbol = requestedSymbol(request.code);
  QRELIEF_TRY(symbol);
  QRELIEF_TRY(checkEngraving(*model, request, *symbol));
  SpotSearchRequest search = spotSearchFor(request, *symbol);
  search.count = kSpots;
  search.scaleToMm = scaleToMm;
  return SpotSearchJob::create(std::move(model), search);
}

Result<Spot> bestSpot(std::shared_ptr<const EngravableModel> model, const EngraveRequest& request,
                      const BestSpotOptions& options) {
  const auto job = searchBestSpot(std::move(model), request, options.scaleToMm);
  QRELIEF_TRY(job);
  QRELIEF_TRY(advanceToEnd(**job, options.tell));
  return (*job)->takeResult().spots.front();
}

PlacementRequest placedAt(const Spot& spot, PlacementRequest placement) {
  placement.centreMm = spot.centreMm;
  if (spot.needsDirection) placement.direction = spot.direction;
  return placement;
}

}  // namespace qrelief
