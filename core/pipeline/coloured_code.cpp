// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/coloured_code.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "label/label_layout.h"
#include "pipeline/mark_depth.h"

namespace qrelief {
namespace {

/// Returns the part of the vertical that rectangles of the QR plane cover. Gaps between them do not count.
/// @param slope  height per unit along the plane's axes
double heightModules(const std::vector<Rectangle>& marked, Vec2 slope) {
  std::vector<std::pair<double, double>> spans;
  for (const auto& [low, high] : marked) {
    const double middle = glm::dot(slope, (low + high) / 2.0), reach = glm::dot(glm::abs(slope), (high - low) / 2.0);
    spans.emplace_back(middle - reach, middle + reach);
  }
  std::sort(spans.begin(), spans.end());
  double sum = 0, end = -INFINITY;
  for (const auto& [from, to] : spans) {
    sum += std::max(0.0, to - std::max(from, end));
    end = std::max(end, to);
  }
  return sum;
}

}  // namespace

ColouredCode colouredCodeOf(const EngraveRequest& request) {
  const Mark mark = request.marking.mark == Mark::Paint ? Mark::Paint : Mark::Inlay;
  return {mark, request.code.lettering(), request.print};
}

int layersOfCode(const Placement& placement, int modules, const ColouredCode& code) {
  if (!code.print.process) return 0;
  const ProjectionFrame& frame = placement.frame;
  const Printer& printer = code.print.printer;
  const Vec3 up = glm::normalize(code.print.buildUp.resolve(frame));
  std::vector<Rectangle> marked;
  if (!code.label.isAlone) marked.push_back({Vec2(-modules / 2.0), Vec2(modules / 2.0)});
  if (const auto label = layOutLabel(code.label, modules))
    marked.insert(marked.end(), label->covered.begin(), label->covered.end());
  const double facing = std::abs(glm::dot(up, frame.normal));
  const double depthLayers = code.mark == Mark::Paint
                                 ? kPaintedLayers * facing
                                 : opaqueDepthMm(std::acos(std::min(1.0, facing)), printer) * facing / printer.layerMm;
  const double heightMm =
      heightModules(marked, {glm::dot(up, frame.right), glm::dot(up, frame.up)}) * placement.moduleMm;
  return static_cast<int>(std::lround(heightMm / printer.layerMm + depthLayers));
}

}  // namespace qrelief
