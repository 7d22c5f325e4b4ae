// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "math/frame.h"
#include "mesh/mesh.h"
#include "render/geometry_pass.h"
#include "render/triangle_clusters.h"

namespace qrelief {

/// Small surface maps drawn by the processor. They equal those of GeometryPass up to rounding and the texels at the
/// border between two facets, but need not wait for the GPU to finish other work.
class SurfaceRaster {
 public:
  /// @param mesh  kept by reference
  explicit SurfaceRaster(const Mesh& mesh);

  /// Draws the facets that face a frame's eye.
  /// Cost: O(T' + texels²) for the T' triangles of the clusters that the window may show.
  /// @returns texels² values of SurfaceMaps::surface: facet's unit normal in the frame's axes, height over the QR plane
  ///          in mm; row 0 at the bottom, all zero where the ray misses the model
  std::vector<float> draw(const ProjectionFrame& frame, const MapWindow& window) const;

  /// Draws the distance from the eye along each texel's ray to the first facet seen from behind, mm; between it and the
  /// front lies material. 0 where there is none. texels² values, row 0 at the bottom; cost as for draw().
  std::vector<float> drawBack(const ProjectionFrame& frame, const MapWindow& window) const;

 private:
  template <class Canvas>
  void drawFacets(Canvas& canvas, const ProjectionFrame& frame, const MapWindow& window, bool front) const;

  const Mesh* mesh_;
  ClusteredTriangles clustered_;
};

}  // namespace qrelief
