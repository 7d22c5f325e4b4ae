// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "pipeline/placement.h"
#include "qr/module_pattern.h"

namespace qrelief {

struct DepthLimitOptions {
  double maxDepthMm = 0;  ///< of every pocket, > 0
  double minWallMm = 0;   ///< material that stays behind every floor, ≥ 0
};

/// Greatest depth of every submodule, mm, 0 where nothing can be carved: the one asked for, distance to the other side
/// of the material in any direction (carving/wall_limit.h), and thickness along every texel's ray, which meets what is
/// too fine for the former's samples.
/// @param thicknessMm  see MeasuredPlace::thicknessMm()
/// @returns row-major from the symbol's top left, as many as the mask has
std::vector<double> depthLimits(const Mesh& mesh, const Placement& placement, const SubmoduleMask& mask,
                                std::span<const double> thicknessMm, const DepthLimitOptions& options);

}  // namespace qrelief
