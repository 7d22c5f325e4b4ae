// SPDX-License-Identifier: GPL-3.0-or-later
#include "delivery/second_colour.h"

#include "pipeline/coloured_code.h"
#include "pipeline/engrave.h"

namespace qrelief {

SecondColour secondColourOf(const EngraveResult& result) {
  const EngraveRequest& request = result.request;
  const auto change = usualFilamentChange(request.print.printer);
  const auto process = processOf(request.print.printer);
  SecondColour second{{}, change.has_value()};
  if (!process) return second;
  const ColourPrint print{request.print.buildUp.resolve(result.placement.frame), *process,
                          change.value_or(FilamentChange{})};
  if (result.inlay)
    second.cost = colourCost(result.mesh, *result.inlay, print);
  else if (!result.painted.empty())
    second.cost = colourCost(result.mesh, PaintedTriangles{result.painted, kPaintedLayers * process->layerMm}, print);
  return second;
}

}  // namespace qrelief
