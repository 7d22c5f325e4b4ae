// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/module_walls.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "depth/wall_limit.h"
#include "qr/module_pattern.h"

namespace qrelief {
namespace {

constexpr double kShrink = 0.98;      // ratio of one size tried to the previous
constexpr double kRounding = 1e-9;    // the depth tested and the depth needed are computed separately
constexpr double kLeastShare = 0.25;  // smallest size tried, as a share of the square

/// @param module  position in modules from the symbol's top left, to the right and down
bool isInFinder(Vec2 module, int modules) {
  const auto isFirst = [](double position) { return position < kFinderModules; };
  const auto isLast = [&](double position) { return position > modules - kFinderModules; };
  return (isFirst(module.y) && (isFirst(module.x) || isLast(module.x))) || (isLast(module.y) && isFirst(module.x));
}

}  // namespace

Result<ModuleWalls> measureModuleWalls(const Mesh& mesh, const SurfaceRenderer& surface, const ProjectionFrame& frame,
                                       const VisiblePatch& patch, CellSquare square, double depthMm, double minWallMm) {
  const int cells = square.cells;
  const MapWindow window{square.edgeMm, cells};
  const auto front = surface.render(frame, window);
  QRELIEF_TRY(front);
  const auto behind = surface.renderBack(frame, window);
  QRELIEF_TRY(behind);
  const std::vector<float> ahead = rayDistances(*front, frame, window);

  const SubmoduleMask all(cells, cells, 1);
  ModuleWalls walls;
  walls.limitMm = wallLimits(mesh, patch, frame, all, {square.edgeMm, depthMm, minWallMm});
  walls.thicknessMm.assign(all.size(), std::numeric_limits<double>::infinity());
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const auto texel = static_cast<std::size_t>((cells - 1 - row) * cells + column);  // row 0 at the bottom
      if (!(ahead[texel] > 0 && (*behind)[texel] > 0)) continue;
      const auto i = static_cast<std::size_t>(row * cells + column);
      walls.thicknessMm[i] = static_cast<double>((*behind)[texel] - ahead[texel]);
      walls.limitMm[i] = std::clamp(walls.thicknessMm[i] - minWallMm, 0.0, walls.limitMm[i]);
    }
  }
  return walls;
}

double pitDepth(double contrast) { return 0.5 * std::sqrt(contrast / (1 - contrast)); }

double sizeThatWallsTake(const ModuleWalls& walls, CellSquare square, int modules, double depthModules,
                         double depthMm) {
  assert(modules > 0 && depthModules >= 0 && depthMm >= 0 && depthModules + depthMm > 0);
  const double cell = square.edgeMm / square.cells;
  const auto takes = [&](double sizeMm) {
    const double depth = (1 - kRounding) * (depthModules * sizeMm / modules + depthMm);
    int inside = 0, thin = 0;
    for (int row = 0; row < square.cells; ++row) {
      for (int column = 0; column < square.cells; ++column) {
        const Vec2 offset = cell * (Vec2(column, row) + 0.5 - square.cells / 2.0);  // from the centre, down
        const Vec2 module = (offset / sizeMm + 0.5) * static_cast<double>(modules);
        if (std::min(module.x, module.y) < 0 || std::max(module.x, module.y) > modules) continue;
        ++inside;
        if (walls.limitMm[row * square.cells + column] >= depth) continue;
        if (isInFinder(module, modules)) return false;
        ++thin;
      }
    }
    return thin <= (1 - kTakenFraction) * inside;
  };
  for (double size = square.edgeMm; size >= kLeastShare * square.edgeMm; size *= kShrink)
    if (takes(size)) return size;
  return 0;
}

}  // namespace qrelief
