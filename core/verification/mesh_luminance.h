// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "light/directional_light.h"
#include "math/frame.h"
#include "mesh/mesh.h"

namespace qrelief {

struct MeshLuminanceOptions {
  int pixels = 400;                          ///< along the edge of the square picture, centred on the code
  double pixelMm = 0.1;                      ///< on the QR plane; walls of pockets stand at borders of pixels
  double nearMm = 10;                        ///< farther surface hides the sky, but throws no sharp shadow
  double albedo = 0.7;                       ///< of the matte material, 0 … 1
  std::vector<DirectionalLight> lamps = {};  ///< beside the uniform sky, at most kMaxLights
  double lampRadiusDeg = 0;                  ///< of their discs
};

/// Luminance of a carved mesh as the frame's eye sees it, 1 = an unoccluded surface in the QR plane; kBackground beside
/// the model. Drawn from the mesh alone, by the processor, and lit as a height map (light/height_light.h).
///
/// Row-major from the lower left. Cost: O(T + pixels²).
std::vector<float> meshLuminance(const Mesh& mesh, const ProjectionFrame& frame, const MeshLuminanceOptions& options);

}  // namespace qrelief
