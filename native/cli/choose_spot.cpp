// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/choose_spot.h"

#include <fmt/format.h>

#include "cli/progress_bar.h"
#include "pipeline/best_spot.h"

namespace qrelief {

Status chooseSpot(std::shared_ptr<const EngravableModel> model, EngraveRequest& request, double scaleToMm, bool quiet,
                  std::FILE* to) {
  const auto spot = [&] {
    ProgressBar bar(quiet);
    return bestSpot(std::move(model), request,
                    {.scaleToMm = scaleToMm, .tell = [&](const Progress& progress) { bar.show(progress); }});
  }();
  if (!spot) return tl::unexpected(spot.error());
  request.placement = placedAt(*spot, request.placement);
  const int decimals = centreDecimals(scaleToMm);
  fmt::print(to, "placed at {:.{}f},{:.{}f},{:.{}f}\n", spot->centreFileUnits.x, decimals, spot->centreFileUnits.y,
             decimals, spot->centreFileUnits.z, decimals);
  return {};
}

}  // namespace qrelief
