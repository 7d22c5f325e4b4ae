// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "math/frame.h"
#include "mesh/mesh.h"
#include "render/geometry_pass.h"
#include "render/triangle_clusters.h"

namespace qrelief {

/// Small surface maps drawn by the processor: what GeometryPass gives, to rounding and but for the texels at the border
/// between two facets, without waiting for the GPU and what it has still to draw.
class SurfaceRaster {
 public:
  /// @param mesh  kept by reference
  explicit SurfaceRaster(const Mesh& mesh);

  /// What a frame's eye sees of the facets that face it.
  /// Cost: O(T' + texels²) for the T' triangles of the clusters that the window may show.
  /// @returns texels² of SurfaceMaps::surface: facet's unit normal in the frame's axes, height over the QR plane in mm;
  ///          row 0 at the bottom, all zero where the ray misses the model
  std::vector<float> draw(const ProjectionFrame& frame, const MapWindow& window) const;

  /// Distance from the eye along each texel's ray to the first facet seen from behind, mm: what lies between it and the
  /// front is material. 0 where there is none. texels² values, row 0 at the bottom; cost as draw().
  std::vector<float> drawBack(const ProjectionFrame& frame, const MapWindow& window) const;

 private:
  template <class Canvas>
  void drawFacets(Canvas& canvas, const ProjectionFrame& frame, const MapWindow& window, bool front) const;

  const Mesh* mesh_;
  ClusteredTriangles clustered_;
};

}  // namespace qrelief
