// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/best_spot.h"

#include <utility>

namespace qrelief {
namespace {

/// Spots to find. The search ranks spots by print and light only once it has found them, so the best of three may be
/// better than the first.
constexpr std::size_t kSpots = 3;

}  // namespace

Result<Spot> bestSpot(std::shared_ptr<const EngravableModel> model, const EngraveRequest& request,
                      const BestSpotOptions& options) {
  const auto symbol = encodeSymbol(request.code.text, request.code.symbol);
  if (!symbol) return tl::unexpected(symbol.error());
  SpotSearchRequest search = spotSearchFor(request, *symbol);
  search.count = kSpots;
  search.scaleToMm = options.scaleToMm;
  const auto job = SpotSearchJob::create(std::move(model), search);
  if (!job) return tl::unexpected(job.error());
  if (const Status done = advanceToEnd(**job, options.tell); !done) return tl::unexpected(done.error());
  return (*job)->takeResult().spots.front();
}

PlacementRequest placedAt(const Spot& spot, PlacementRequest placement) {
  placement.centreMm = spot.centreMm;
  if (spot.needsDirection) placement.direction = spot.direction;
  return placement;
}

}  // namespace qrelief
