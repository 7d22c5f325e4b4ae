// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/second_colour.h"

#include <cmath>

#include "pipeline/engrave.h"
#include "pipeline/mark_depth.h"

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

int layersOfCode(const Placement& placement, const PrinterRequest& print) {
  if (!print.process) return 0;
  const ProjectionFrame& frame = placement.frame;
  const Vec3 up = glm::normalize(print.buildUp.resolve(frame));
  const double heightMm = placement.symbolMm * (std::abs(glm::dot(up, frame.right)) + std::abs(glm::dot(up, frame.up)));
  return static_cast<int>(std::ceil(heightMm / print.printer.layerMm) + kInlayLayers);
}

}  // namespace qrelief
