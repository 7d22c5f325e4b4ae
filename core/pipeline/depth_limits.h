// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/mesh.h"
#include "pipeline/cell_layout.h"
#include "pipeline/placement.h"
#include "render/geometry_pass.h"

namespace qrelief {

/// What the eye sees of a model, from in front and from behind, in maps of one window.
struct FrontAndBack {
  const SurfaceMaps& front;
  const BackDistanceMap& back;
  CellLayout layout;  ///< of the symbol in them
};

struct DepthLimitOptions {
  double maxDepthMm = 0;  ///< of every pocket, > 0
  double minWallMm = 0;   ///< material that stays behind every floor, ≥ 0
};

/// Greatest depth of every submodule, mm, 0 where nothing can be carved: the one asked for, distance to the other side
/// of the material in any direction (carving/wall_limit.h), and thickness along every texel's ray, which meets what is
/// too fine for the former's samples.
/// @returns row-major from the symbol's top left, as many as the mask has
std::vector<double> depthLimits(const Mesh& mesh, const Placement& placement, const SubmoduleMask& mask,
                                const FrontAndBack& maps, const DepthLimitOptions& options);

}  // namespace qrelief
