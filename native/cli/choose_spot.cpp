// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/choose_spot.h"

#include <fmt/format.h>

#include "cli/progress_bar.h"
#include "pipeline/spot_search.h"

namespace qrelief {

Status chooseSpot(std::shared_ptr<const EngravableModel> model, EngraveRequest& request, double scaleToMm, bool quiet,
                  std::FILE* to) {
  const auto symbol = encodeSymbol(request.code.text, request.code.symbol);
  if (!symbol) return tl::unexpected(symbol.error());
  SpotSearchRequest search = spotSearchFor(request, *symbol);
  search.count = 3;
  search.scaleToMm = scaleToMm;
  auto job = SpotSearchJob::create(std::move(model), search);
  if (!job) return tl::unexpected(job.error());
  if (const Status done = runWithProgress(**job, quiet); !done) return done;
  const Spot spot = (*job)->takeResult().spots.front();
  request.placement.centreMm = spot.centreMm;
  if (spot.needsDirection) request.placement.direction = spot.direction;
  const int decimals = centreDecimals(scaleToMm);
  fmt::print(to, "placed at {:.{}f},{:.{}f},{:.{}f}\n", spot.centreFileUnits.x, decimals, spot.centreFileUnits.y,
             decimals, spot.centreFileUnits.z, decimals);
  return {};
}

}  // namespace qrelief
