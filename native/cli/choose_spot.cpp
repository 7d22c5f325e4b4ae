// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/choose_spot.h"

#include <fmt/format.h>

#include "cli/progress_bar.h"
#include "pipeline/best_spot.h"

namespace qrelief {

void printSpot(Vec3 centreMm, double scaleToMm, std::FILE* to) {
  const int decimals = centreDecimals(scaleToMm);
  const Vec3 centre = centreMm / scaleToMm;
  fmt::print(to, "placed at {:.{}f},{:.{}f},{:.{}f}\n", centre.x, decimals, centre.y, decimals, centre.z, decimals);
}

Status chooseSpot(std::shared_ptr<const EngravableModel> model, EngraveRequest& request, double scaleToMm, bool quiet,
                  std::FILE* to) {
  const auto spot = [&] {
    ProgressBar bar(quiet);
    return bestSpot(std::move(model), request,
                    {.scaleToMm = scaleToMm, .tell = [&](const Progress& progress) { bar.show(progress); }});
  }();
  QRELIEF_TRY(spot);
  request.placement = placedAt(*spot, request.placement);
  printSpot(spot->centreMm, scaleToMm, to);
  return {};
}

}  // namespace qrelief
