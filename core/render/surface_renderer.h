// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/result.h"
#include "math/box.h"
#include "math/frame.h"

namespace qrelief {

/// The square of the QR plane that a map covers, centred on the code.
struct MapWindow {
  double extentMm = 0;  ///< edge of the square
  int texels = 0;       ///< along the edge; texel (0, 0) at the lower left

  double texelMm() const { return extentMm / texels; }
  /// Returns the plane point of a texel's middle.
  Vec2 planePoint(int column, int row) const {
    return {(column + 0.5) * texelMm() - extentMm / 2, (row + 0.5) * texelMm() - extentMm / 2};
  }
};

/// Returns the window, 256 texels wide, in which the eye sees the model around a map: the whole model, but at most 16
/// times the map's width.
MapWindow surroundingsOf(const MapWindow& map, const ProjectionFrame& frame, const Box3& model);

/// Draws maps of one model's surface by the central projection of a frame [Papp 2022, §3]: on the GPU (GpuSurface) or
/// with the processor (SurfaceRaster). Maps are texels² values, row 0 at the bottom.
class SurfaceRenderer {
 public:
  virtual ~SurfaceRenderer() = default;

  /// Draws the facets that face the eye. Four values per texel: the facet's unit normal in the frame's axes (right, up,
  /// normal) and the height over the QR plane, mm. All are zero where the ray misses the model.
  /// @returns Internal if the GL implementation cannot draw the map
  virtual Result<std::vector<float>> render(const ProjectionFrame& frame, const MapWindow& window) const = 0;

  /// Draws the distance from the eye along each texel's ray to the first facet seen from behind, mm; between it and the
  /// front lies material. 0 where there is none. Errors as for render().
  virtual Result<std::vector<float>> renderBack(const ProjectionFrame& frame, const MapWindow& window) const = 0;

 protected:
  SurfaceRenderer() = default;
  SurfaceRenderer(const SurfaceRenderer&) = default;
  SurfaceRenderer(SurfaceRenderer&&) = default;
  SurfaceRenderer& operator=(const SurfaceRenderer&) = default;
  SurfaceRenderer& operator=(SurfaceRenderer&&) = default;
};

/// Returns the distances from the eye along the rays of a map, mm; 0 where the ray misses the model.
/// @param surface  normals and heights, as from SurfaceRenderer::render()
std::vector<float> rayDistances(const std::vector<float>& surface, const ProjectionFrame& frame,
                                const MapWindow& window);

}  // namespace qrelief
