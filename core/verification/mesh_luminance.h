// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/grid.h"
#include "light/directional_light.h"
#include "math/frame.h"
#include "mesh/mesh.h"
#include "render/surface_raster.h"

namespace qrelief {

struct MeshLuminanceOptions {
  int pixels = 400;                          ///< along the edge of the square picture, centred on the code
  double pixelMm = 0.1;                      ///< on the QR plane; choose it so that pocket walls lie on pixel borders
  double nearMm = 10;                        ///< farther surfaces hide the sky but cast no sharp shadow
  double albedo = 0.7;                       ///< reflectance of the matte material, 0 … 1
  std::vector<DirectionalLight> lamps = {};  ///< in addition to the uniform sky, at most kMaxLights
  double lampRadiusDeg = 0;                  ///< angular radius of the lamps' discs
};

/// Returns the luminance of a carved mesh as the frame's eye sees it, 1 = an unoccluded surface in the QR plane;
/// kBackground off the model. The processor draws it from the mesh alone and lights it as a height map
/// (light/height_light.h).
///
/// Cost: O(T + pixels²).
BottomUp<float> meshLuminance(const Mesh& mesh, const ProjectionFrame& frame, const MeshLuminanceOptions& options);

/// The same for a mesh that has a raster already. Cost: O(T) only for the surroundings.
/// @param box  of the mesh
BottomUp<float> meshLuminance(const SurfaceRaster& raster, const Box3& box, const ProjectionFrame& frame,
                              const MeshLuminanceOptions& options);

}  // namespace qrelief
