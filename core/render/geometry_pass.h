// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "gl/objects.h"
#include "math/frame.h"
#include "render/gpu_mesh.h"
#include "render/surface_renderer.h"

namespace qrelief {

/// The surface as the eye sees it: facet normals, smooth normals, heights, distances. Normals are in the frame's axes
/// (right, up, normal), heights in mm over the QR plane, distances in mm from the eye along the rays. All are zero
/// where the ray misses the model.
struct SurfaceMaps {
  MapWindow window;
  gl::Texture surface;          ///< RGBA32F: facet normal, height over the QR plane
  gl::Texture smooth;           ///< RGBA32F: interpolated vertex normal, distance
  gl::Framebuffer framebuffer;  ///< attachment 0 = surface, 1 = smooth
};

/// Distance to the first facet seen from behind, mm; 0 where there is none. Subtract the front distance to get the
/// thickness.
struct BackDistanceMap {
  gl::Texture distance;  ///< R32F
  gl::Framebuffer framebuffer;
};

/// Renders a model by the central projection of a frame [Papp 2022, §3].
class GeometryPass {
 public:
  static Result<GeometryPass> create();

  Result<SurfaceMaps> render(const GpuMesh& mesh, const ProjectionFrame& frame, const MapWindow& window) const;
  Result<BackDistanceMap> renderBack(const GpuMesh& mesh, const ProjectionFrame& frame, const MapWindow& window) const;

 private:
  void draw(const gl::Program& program, GLenum culled, const GpuMesh& mesh, const ProjectionFrame& frame,
            const MapWindow& window) const;
  gl::Program front_, back_;
};

}  // namespace qrelief
