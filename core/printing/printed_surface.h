// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/result.h"
#include "light/height_map.h"
#include "math/frame.h"
#include "mesh/mesh.h"
#include "printing/print_process.h"

namespace qrelief {

/// Which part of a model is printed, and how.
struct PrintRequest {
  PrintProcess process;
  ProjectionFrame frame;  ///< of the code, in the model's space
  double extentMm = 50;   ///< edge of the square of the QR plane that is looked at, centred on the code
  Vec3 buildUp{0, 0, 1};  ///< the printer's vertical in the model's space, of any length > 0
  double roughness = 1;   ///< how much wider texels and nodes are than what shows everything, ≥ 1
};

/// The surface that a printer leaves, as the reader's eye sees it.
struct PrintedSurface {
  ProjectionFrame frame;
  int texels = 0;                 ///< along the edge of the square, at the middles of which rays meet the surface
  double texelMm = 0;             ///< on the QR plane
  std::vector<float> distanceMm;  ///< from the eye along the rays, row-major from the lower left; 0 = nothing is met

  Vec2 planePoint(int column, int row) const {
    return {(column + 0.5 - texels / 2.0) * texelMm, (row + 0.5 - texels / 2.0) * texelMm};
  }

  /// eyeDistance²/depth − eyeDistance, mm: close to the height over the QR plane, and linear over whatever is plane in
  /// space. −infinity where nothing is met.
  float height(int column, int row) const;

  /// A patch for each square between four points, and half squares along the border: texels + 1 along the edge, each of
  /// texelMm. Where one of the four is missing there is nothing.
  HeightMap heightMap() const;

  /// The points joined to triangles, along the diagonals whose ends are nearer to one height: a surface with a border,
  /// right for rendering, and no solid.
  Mesh mesh() const;
};

/// What a printer makes of a solid round a code.
///
/// The solid is cut into layers, at half the height of each; every layer is made as laid_outline.h says; its flanks are
/// round, so that a groove lies between two layers; skins end with whole layers. Not in it:
/// stringing, ringing, over- and under-extrusion, sagging, shrinkage, gloss.
///
/// Cost: O(triangles) and O(extent² / finest²) for each layer that the surface passes; at most a million texels and 40
/// million nodes, coarser ones where more would be needed.
/// @param mesh  a solid
/// @returns BadUsage for a build direction of zero
Result<PrintedSurface> printSurface(const Mesh& mesh, const PrintRequest& request);

}  // namespace qrelief
