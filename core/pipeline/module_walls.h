// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/result.h"
#include "math/frame.h"
#include "mesh/mesh.h"
#include "projection/silhouette.h"
#include "render/geometry_pass.h"

namespace qrelief {

/// Of the modules, these must take pockets: error correction restores the few others.
inline constexpr double kTakenFraction = 0.98;

/// A square of cells about the origin of the QR plane, each the size of a module.
struct CellSquare {
  double edgeMm = 0;  ///< > 0
  int cells = 0;      ///< along the edge, ≥ 1
};

/// The material under each cell of a square, row-major from its top left.
struct ModuleWalls {
  std::vector<double> limitMm;      ///< how deep it may be carved (see wallLimits), 0 … the depth asked about
  std::vector<double> thicknessMm;  ///< along the ray through its centre; infinite where nothing lies behind
};

/// @param patch     covers the square; known minWallMm + depthMm farther than it reaches
/// @param depthMm   that is asked about, > 0
/// @param minWallMm material that must remain, ≥ 0
Result<ModuleWalls> measureModuleWalls(const Mesh& mesh, const GpuMesh& gpu, const GeometryPass& pass,
                                       const ProjectionFrame& frame, const VisiblePatch& patch, CellSquare square,
                                       double depthMm, double minWallMm);

/// Depth, in widths of it, at which a round pit's floor is darker than the open surface by `contrast`: visibility of
/// the sky there is r²/(r² + d²). What a lone module needs, about; modules among others need more.
/// @param contrast  0 < c < 1
double pitDepth(double contrast);

/// The largest code about the origin, no larger than the square, whose walls take the pockets: under all modules of its
/// finder patterns, and under nearly all others. A smaller code reaches less far, and its pockets are less deep.
/// @param walls         of the square
/// @param modules       of the symbol along its edge
/// @param depthModules  of the pockets, in modules, > 0
/// @returns mm; 0 if there is none of a quarter of the square's size
double sizeThatWallsTake(const ModuleWalls& walls, CellSquare square, int modules, double depthModules);

}  // namespace qrelief
