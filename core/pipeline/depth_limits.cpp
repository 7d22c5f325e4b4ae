// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/depth_limits.h"

#include <algorithm>
#include <limits>

#include "carving/wall_limit.h"

namespace qrelief {
namespace {

/// Along the rays through each submodule, the least; infinite where no ray meets both sides.
std::vector<double> thicknesses(const SubmoduleMask& mask, const FrontAndBack& maps) {
  const std::vector<float> behind = maps.back.framebuffer.readRed();
  const std::vector<float> ahead = maps.front.framebuffer.readRgba(1);
  const int texels = maps.front.window.texels, cells = maps.layout.cells(), perCell = texels / cells;
  std::vector<double> thickness(mask.carved.size(), std::numeric_limits<double>::infinity());
  for (int row = 0; row < mask.size; ++row)
    for (int column = 0; column < mask.size; ++column) {
      const auto cell = static_cast<int>(maps.layout.ofSymbol(row, column));
      const auto i = static_cast<std::size_t>(row * mask.size + column);
      for (int t = 0; t < perCell * perCell; ++t) {
        const int y = cell / cells * perCell + t / perCell, x = cell % cells * perCell + t % perCell;
        const auto texel = static_cast<std::size_t>(y * texels + x);
        const float front = ahead[4 * texel + 3];
        if (front > 0 && behind[texel] > 0) thickness[i] = std::min<double>(thickness[i], behind[texel] - front);
      }
    }
  return thickness;
}

}  // namespace

std::vector<double> depthLimits(const Mesh& mesh, const Placement& placement, const SubmoduleMask& mask,
                                const FrontAndBack& maps, const DepthLimitOptions& options) {
  const std::vector<double> thickness = thicknesses(mask, maps);
  std::vector<double> limits = wallLimits(mesh, placement.patch, placement.frame, mask,
                                          {placement.symbolMm, options.maxDepthMm, options.minWallMm});
  for (std::size_t i = 0; i < limits.size(); ++i)
    limits[i] = std::max(0.0, std::min(limits[i], thickness[i] - options.minWallMm));
  return limits;
}

}  // namespace qrelief
