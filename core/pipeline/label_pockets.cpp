// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/label_pockets.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "depth/depth_field.h"
#include "mesh/ray_tree.h"
#include "message_codes/text.h"
#include "pipeline/engrave.h"
#include "settings/engrave_request.h"

namespace qrelief {
namespace {

/// Returns the least thickness of the material along the eye's rays through the label's corners, mm.
double leastThicknessMm(const Mesh& mesh, const ProjectionFrame& frame, const std::vector<Ring>& rings) {
  const RayTree tree(mesh);
  double least = std::numeric_limits<double>::infinity();
  for (const Ring& ring : rings)
    for (const Vec2 corner : ring) {
      const Vec3 eye = frame.eye(), direction = frame.rayDirection(corner);
      const auto front = tree.firstHit(eye, direction);
      if (!front) continue;
      const double reached = glm::distance(front->position, eye);
      const auto back = tree.firstHit(eye, direction, reached + kOnSurfaceMm);
      if (back) least = std::min(least, glm::distance(back->position, front->position));
    }
  return least;
}

}  // namespace

Status checkStrokes(const LabelOptions& label, const LabelLayout& layout, int modules, double sizeMm) {
  const double strokeMm = layout.thinnestStrokeModules * sizeMm / modules;
  if (label.empty() || strokeMm >= kMinStrokeMm) return {};
  if (!label.isAlone)
    return fail(ErrorKind::NoSolution, message<"label-strokes-too-thin">(with::lengthMm<"stroke">(strokeMm),
                                                                         with::lengthMm<"least">(kMinStrokeMm)));
  return fail(ErrorKind::NoSolution,
              message<"text-strokes-too-thin">(with::lengthMm<"size">(sizeMm), with::lengthMm<"stroke">(strokeMm),
                                               with::lengthMm<"least">(kMinStrokeMm),
                                               with::lengthMm<"needed">(std::ceil(sizeMm * kMinStrokeMm / strokeMm))));
}

Result<OutlinedPockets> labelPockets(const EngraveRequest& request, const Mesh& mesh, const Placement& placement,
                                     int modules, double inlayMm) {
  const LabelOptions label = request.code.lettering();
  if (label.empty()) return OutlinedPockets{};
  auto layout = layOutLabel(label, modules);
  QRELIEF_TRY(layout);
  QRELIEF_TRY(checkStrokes(label, *layout, modules, modules * placement.moduleMm));
  OutlinedPockets pockets{std::move(layout->rings), std::move(layout->covered), 0};
  for (Ring& ring : pockets.rings)
    for (Vec2& corner : ring) corner *= placement.moduleMm;
  for (Rectangle& box : pockets.covered) box = {box.low * placement.moduleMm, box.high * placement.moduleMm};
  if (request.marking.mark == Mark::Paint) {
    pockets.depthMm = kDepthQuantumMm;  // marks what is painted, and lowers nothing
    return pockets;
  }
  const double layerMm = request.print.printer.layerMm;
  const double wantedMm = request.marking.mark == Mark::Inlay ? inlayMm : kLabelLayers * layerMm;
  const double thicknessMm = leastThicknessMm(mesh, placement.frame, pockets.rings);
  pockets.depthMm = quantisedDepth(wantedMm, std::min(wantedMm, thicknessMm - request.depth.minWallMm));
  if (pockets.depthMm < std::max(layerMm, kDepthQuantumMm) - 1e-9) {
    const double leftMm = std::max(0.0, thicknessMm - wantedMm);
    return fail(ErrorKind::NoSolution,
                label.isAlone
                    ? message<"text-too-deep">(with::lengthMm<"depth">(wantedMm), with::lengthMm<"wall">(leftMm))
                    : message<"label-too-deep">(with::lengthMm<"depth">(wantedMm), with::lengthMm<"wall">(leftMm)));
  }
  return pockets;
}

std::optional<double> labelCapitalMm(const LabelOptions& label, int modules, double moduleMm) {
  if (label.text.empty()) return std::nullopt;
  const auto layout = layOutLabel(label, modules);
  if (!layout) return std::nullopt;
  return layout->capitalModules * moduleMm;
}

std::optional<double> capitalMmOf(const EngraveResult& result) {
  return labelCapitalMm(result.request.code.lettering(), result.symbol.size, result.placement.moduleMm);
}

}  // namespace qrelief
