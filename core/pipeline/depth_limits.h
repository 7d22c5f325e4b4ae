// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "pipeline/placement.h"
#include "qr/module_pattern.h"

namespace qrelief {

struct DepthLimitOptions {
  double maxDepthMm = 0;  ///< limit for every pocket, > 0
  double minWallMm = 0;   ///< material that must remain behind every floor, ≥ 0
};

/// Returns the greatest depth of every submodule, mm; 0 where nothing can be carved. It is the least of three limits:
/// the requested depth; the distance to the other side of the material in any direction (depth/wall_limit.h); and the
/// thickness along every texel's ray, which catches features too fine for the samples of the second limit.
/// @param thicknessMm  see PlacementMeasurement::thicknessMm()
/// @returns one value for each submodule of the mask, row-major from the symbol's top left
std::vector<double> depthLimits(const Mesh& mesh, const Placement& placement, const SubmoduleMask& mask,
                                std::span<const double> thicknessMm, const DepthLimitOptions& options);

}  // namespace qrelief
