// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "math/frame.h"
#include "mesh/ray_tree.h"
#include "mesh/topology.h"
#include "qr/symbol.h"

namespace qrelief {

/// A code is raised or carved if it is so by more than this, mm: less is the grain of a model.
inline constexpr double kFlatMm = 0.02;

/// How a symbol may lie in the place where it is looked for.
enum class SymbolPose : std::uint8_t { AsWanted, Turned90, Turned180, Turned270, Mirrored, None };

/// What is carved where a symbol should be, as the mesh itself has it.
struct CarvingProfile {
  SymbolPose pose = SymbolPose::None;  ///< None: nothing there fits the symbol
  double fit = 0;  ///< fraction of the windows' unevenness that dark and light modules explain, 0 … 1, for `pose`
  double meanDepthMm = 0;  ///< over the carved submodules; negative: they are raised
  /// Of each submodule under the surface that the light modules around it suggest, (5·modules)², row-major from the
  /// symbol's top left; 0 in light modules; NaN where the model is missed. Empty if pose is None.
  std::vector<double> depthMm;
  std::vector<std::uint8_t> carved;  ///< for the same submodules: 1 = nearly as deep as the deepest of its module
  /// Where each submodule's middle ray meets the model; triangle kNoTriangle where it misses.
  std::vector<SurfacePoint> points;
};

/// Compares the heights of the modules with the symbol in each of its eight poses: in a window of 5 × 5 modules round
/// each, a quadratic surface and one step between dark and light are fitted by least squares; the pose that explains
/// most wins. The step's sign says whether modules are carved or raised, whatever the light does.
///
/// Cost: 25 rays a module of symbol and quiet zone, and modules × 8 small systems.
CarvingProfile profileCarving(const RayTree& tree, const ProjectionFrame& frame, const Symbol& symbol, double symbolMm);

}  // namespace qrelief
