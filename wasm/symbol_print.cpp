// SPDX-License-Identifier: GPL-3.0-or-later
#include "wasm/symbol_print.h"

#include <algorithm>

namespace qrelief {
namespace {

constexpr double kPrintHeights = 0.75;     // farthest surface from the QR plane that takes the print, of its edge
constexpr double kHeightTolerance = 0.02;  // of the print's edge: floats of two different projections

/// Range of heights over the QR plane among the patch's facets that the square covers.
Vec2 heightsUnder(const Placement& placement, const Mesh& mesh, double edge) {
  const ProjectionFrame& frame = placement.frame;
  Vec2 range(0);
  for (const std::uint32_t t : placement.patch.triangles) {
    Vec2 low(edge), high(-edge);
    Vec2 heights(edge, -edge);
    for (int k = 0; k < 3; ++k) {
      const Vec3 corner = mesh.corner(t, k);
      const Vec2 p = frame.project(corner);
      low = glm::min(low, p);
      high = glm::max(high, p);
      const double height = glm::dot(corner - frame.centre, frame.normal);
      heights = {std::min(heights.x, height), std::max(heights.y, height)};
    }
    if (high.x < -edge / 2 || high.y < -edge / 2 || low.x > edge / 2 || low.y > edge / 2) continue;
    range = {std::min(range.x, heights.x), std::max(range.y, heights.y)};
  }
  range = glm::clamp(range, Vec2(-kPrintHeights * edge), Vec2(kPrintHeights * edge));
  return range + Vec2(-kHeightTolerance, kHeightTolerance) * edge;
}

}  // namespace

SurfacePrint symbolPrint(const Symbol& symbol, const Placement& placement, const EngraveRequest& request,
                         const Mesh& mesh) {
  const SubmoduleMask mask = submodulesToCarve(symbol, request.modulePattern, request.finderPattern);
  const int border = kSubmodulesPerModule * kQuietZoneModules;
  SurfacePrint print;
  print.frame = placement.frame;
  print.size = mask.size + 2 * border;
  print.edgeMm = placement.symbolMm * print.size / mask.size;
  print.heightsMm = heightsUnder(placement, mesh, print.edgeMm);
  print.ink.assign(static_cast<std::size_t>(print.size) * static_cast<std::size_t>(print.size), 0);
  for (int row = 0; row < mask.size; ++row)
    for (int column = 0; column < mask.size; ++column)
      if (mask.isCarved(row, column))
        print.ink[static_cast<std::size_t>((row + border) * print.size + column + border)] = 255;
  return print;
}

}  // namespace qrelief
