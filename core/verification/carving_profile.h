// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "math/frame.h"
#include "mesh/ray_tree.h"
#include "mesh/topology.h"
#include "qr/symbol.h"

namespace qrelief {

/// Height difference, mm, above which a code counts as raised or carved. Smaller differences are the grain of a model.
inline constexpr double kFlatMm = 0.02;

/// Orientation of a symbol at the place where it is expected.
enum class SymbolPose : std::uint8_t { AsWanted, Turned90, Turned180, Turned270, Mirrored, None };

/// The carving at the place of a symbol, measured on the mesh itself.
struct CarvingProfile {
  SymbolPose pose = SymbolPose::None;  ///< None: the surface does not fit the symbol
  double fit = 0;  ///< fraction of the windows' unevenness that dark and light modules explain, 0 … 1, for `pose`
  double meanDepthMm = 0;  ///< over the carved submodules; negative: they are raised
  /// Depth of each submodule below the surface fitted to the light modules around it; 0 in light modules; NaN where the
  /// model is missed. Empty if pose is None.
  Grid<double> depthMm;
  Grid<std::uint8_t> carved;  ///< for the same submodules: 1 = nearly as deep as the deepest of its module
  /// Point where each submodule's middle ray meets the model; kNoTriangle where it misses.
  Grid<SurfacePoint> points;
};

/// Compares the heights of the modules with the symbol in each of its eight poses. In a window of 5 × 5 modules round
/// each module, fits a quadratic surface and one step between dark and light by least squares; the pose that explains
/// most wins. The sign of the step tells carved from raised modules, independent of the light.
///
/// Cost: 25 rays per module of symbol and quiet zone, and modules × 8 small systems.
CarvingProfile profileCarving(const RayTree& tree, const ProjectionFrame& frame, const Symbol& symbol, double symbolMm);

}  // namespace qrelief
