// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/depth_limits.h"

#include <algorithm>

#include "depth/wall_limit.h"

namespace qrelief {

std::vector<double> depthLimits(const Mesh& mesh, const Placement& placement, const SubmoduleMask& mask,
                                std::span<const double> thicknessMm, const DepthLimitOptions& options) {
  std::vector<double> limits = wallLimits(mesh, placement.patch, placement.frame, mask,
                                          {placement.symbolMm, options.maxDepthMm, options.minWallMm});
  for (std::size_t i = 0; i < limits.size(); ++i)
    limits[i] = std::max(0.0, std::min(limits[i], thicknessMm[i] - options.minWallMm));
  return limits;
}

}  // namespace qrelief
