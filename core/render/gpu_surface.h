// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "render/geometry_pass.h"
#include "render/gpu_mesh.h"
#include "render/surface_renderer.h"

namespace qrelief {

/// A model's surface in GPU memory, with the pass that draws it.
class GpuSurface final : public SurfaceRenderer {
 public:
  /// @param pass  of the mesh's GL context, not null
  GpuSurface(std::shared_ptr<const GeometryPass> pass, GpuMesh mesh) : pass_(std::move(pass)), mesh_(std::move(mesh)) {}

  /// Draws the maps and leaves them on the GPU.
  Result<SurfaceMaps> maps(const ProjectionFrame& frame, const MapWindow& window) const {
    return pass_->render(mesh_, frame, window);
  }
  Result<BackDistanceMap> backMap(const ProjectionFrame& frame, const MapWindow& window) const {
    return pass_->renderBack(mesh_, frame, window);
  }

  /// Draws a map and reads it back.
  Result<std::vector<float>> render(const ProjectionFrame& frame, const MapWindow& window) const override;
  Result<std::vector<float>> renderBack(const ProjectionFrame& frame, const MapWindow& window) const override;

 private:
  std::shared_ptr<const GeometryPass> pass_;
  GpuMesh mesh_;
};

}  // namespace qrelief
