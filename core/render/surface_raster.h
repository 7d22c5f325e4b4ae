// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "math/frame.h"
#include "mesh/mesh.h"
#include "mesh/triangle_clusters.h"
#include "render/surface_renderer.h"

namespace qrelief {

/// Draws surface maps with the processor. They equal the maps of GpuSurface up to rounding and the texels at the border
/// between two facets, but need no GL context and do not wait for the GPU to finish other work.
class SurfaceRaster final : public SurfaceRenderer {
 public:
  /// @param mesh  kept by reference
  explicit SurfaceRaster(const Mesh& mesh);
  /// @param clusters  of the same mesh
  SurfaceRaster(const Mesh& mesh, std::shared_ptr<const ClusteredTriangles> clusters);

  /// Draw the maps of render() and renderBack(); never fail.
  /// Cost: O(T' + texels²) for the T' triangles of the clusters that the window may show.
  std::vector<float> draw(const ProjectionFrame& frame, const MapWindow& window) const;
  std::vector<float> drawBack(const ProjectionFrame& frame, const MapWindow& window) const;

  Result<std::vector<float>> render(const ProjectionFrame& frame, const MapWindow& window) const override {
    return draw(frame, window);
  }
  Result<std::vector<float>> renderBack(const ProjectionFrame& frame, const MapWindow& window) const override {
    return drawBack(frame, window);
  }

 private:
  template <class Canvas>
  void drawFacets(Canvas& canvas, const ProjectionFrame& frame, const MapWindow& window, bool front) const;

  const Mesh* mesh_;
  std::shared_ptr<const ClusteredTriangles> clustered_;
};

}  // namespace qrelief
