// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/result.h"
#include "light/height_map.h"
#include "math/frame.h"
#include "mesh/mesh.h"
#include "printing/print_process.h"

namespace qrelief {

/// The part of a model to print, and the process.
struct PrintRequest {
  PrintProcess process;
  ProjectionFrame frame;  ///< of the code, in the model's space
  double extentMm = 50;   ///< edge of the visible square of the QR plane, centred on the code
  Vec3 buildUp{0, 0, 1};  ///< the printer's vertical in the model's space, any length > 0
  double roughness = 1;   ///< factor by which texels and nodes are larger than full detail needs, ≥ 1
};

/// The surface of a print, as the eye sees it.
struct PrintedSurface {
  ProjectionFrame frame;
  int texels = 0;                 ///< along the edge of the square; a ray through the middle of each meets the surface
  double texelMm = 0;             ///< on the QR plane
  std::vector<float> distanceMm;  ///< from the eye along the rays, row-major from the lower left; 0 = no hit

  Vec2 planePoint(int column, int row) const {
    return {(column + 0.5 - texels / 2.0) * texelMm, (row + 0.5 - texels / 2.0) * texelMm};
  }

  /// Returns eyeDistance²/depth − eyeDistance, mm: close to the height over the QR plane, and linear over any plane in
  /// space. −infinity where the ray hits nothing.
  float height(int column, int row) const;

  /// Returns a height map with a patch for each square between four points, and half squares along the border: texels +
  /// 1 along the edge, each of texelMm. A patch is empty if one of its four points is missing.
  HeightMap heightMap() const;

  /// Returns the points joined to triangles, along the diagonals whose ends differ less in height: a surface with a
  /// border, suitable for rendering, but not a solid.
  Mesh mesh() const;
};

/// Simulates the print of a solid around a code.
///
/// It cuts the solid into layers, at half the height of each, and shapes every layer as in extruded_outline.h. The
/// layers' flanks are round, so that a groove lies between two layers; tops and bottoms are whole layers. It omits
/// stringing, ringing, over- and under-extrusion, sagging, shrinkage or gloss.
///
/// Cost: O(triangles) and O(extent² / finest²) for each layer that the surface passes; at most a million texels and 40
/// million nodes, with coarser steps where more would be needed.
/// @param mesh  a solid
/// @returns BadUsage for a build direction of zero
Result<PrintedSurface> printSurface(const Mesh& mesh, const PrintRequest& request);

}  // namespace qrelief
