// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/result.h"
#include "math/frame.h"
#include "mesh/mesh.h"
#include "projection/silhouette.h"
#include "render/surface_renderer.h"

namespace qrelief {

/// Share of the modules that must take pockets; error correction restores the rest.
inline constexpr double kTakenFraction = 0.98;

/// A square of module-sized cells centred at the origin of the QR plane.
struct CellSquare {
  double edgeMm = 0;  ///< > 0
  int cells = 0;      ///< along the edge, ≥ 1
};

/// The material under each cell of a square, row-major from its top left.
struct ModuleWalls {
  std::vector<double> limitMm;      ///< greatest depth (see wallLimits), 0 … `depthMm`
  std::vector<double> thicknessMm;  ///< along the ray through the cell's centre; infinite without a far side
};

/// @param surface   of the mesh
/// @param patch     covers the square and minWallMm + depthMm beyond it
/// @param depthMm   depth to test, > 0
/// @param minWallMm material that must remain, ≥ 0
Result<ModuleWalls> measureModuleWalls(const Mesh& mesh, const SurfaceRenderer& surface, const ProjectionFrame& frame,
                                       const VisiblePatch& patch, CellSquare square, double depthMm, double minWallMm);

/// Returns the depth of a round pit, in its widths, whose floor is darker than the open surface by `contrast`: the
/// floor sees r²/(r² + d²) of the sky. This is about the depth that a lone module needs; modules among others need
/// more.
/// @param contrast  0 < c < 1
double pitDepth(double contrast);

/// Returns the size of the largest code, centred at the origin and no larger than the square, for which the walls are
/// thick enough: under all modules of its finder patterns and nearly all others. A smaller code covers less area and
/// has shallower pockets.
/// @param walls         walls under the square
/// @param modules       along the symbol's edge
/// @param depthModules  depth of the pockets, in modules, ≥ 0
/// @param depthMm       added to that depth at every size, ≥ 0; at least one of the two is > 0
/// @returns mm; 0 if no code of at least a quarter of the square's size fits
double sizeThatWallsTake(const ModuleWalls& walls, CellSquare square, int modules, double depthModules,
                         double depthMm = 0);

}  // namespace qrelief
