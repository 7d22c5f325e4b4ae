// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gl/objects.h"
#include "light/directional_light.h"
#include "math/vec.h"
#include "render/gpu_mesh.h"
#include "viewer/orbit_camera.h"

namespace qrelief {

/// A plane that cuts away everything on the side that its normal points to.
struct CuttingPlane {
  Vec3 point{0};
  Vec3 normal{0, 0, 1};  ///< unit
};

/// Light of a uniform sky and of lamps so far away that their rays are parallel.
struct LampLight {
  struct Lamp {
    Vec3 towards{0, 0, 1};  ///< model space, unit
    double strength = 1;    ///< irradiance of a surface that faces it, 1 = irradiance by the whole sky

    bool operator==(const Lamp&) const = default;
  };
  std::vector<Lamp> lamps;    ///< at most kMaxLights
  double openIrradiance = 1;  ///< of the code's plane, 1 = by the whole sky; luminances are divided by it; > 0
  double albedo = 0.7;        ///< of the material, 0 … 1, for the light that it reflects into its hollows
  Vec3 centre{0};             ///< of a sphere in which shadows are fine; model space
  double radiusMm = 10;       ///< of the sphere, > 0

  bool operator==(const LampLight&) const = default;
};

/// Shadow maps of the lamps: of each, one of the whole mesh and a finer one of the sphere. draw() makes only what
/// is missing.
///
/// Needs the GL context that was current when it was made.
class LampShadows {
 public:
  static Result<LampShadows> create();

  /// Forgets the maps, because the mesh or its cut has changed.
  void forget() { drawn_ = {}; }
  /// Draws the maps that are missing. Leaves another framebuffer bound.
  /// Cost: draws the mesh twice for each lamp that has changed, and once if only the sphere has.
  /// @param texels  along an edge of a map
  Status draw(const LampLight& light, const GpuMesh& mesh, const std::optional<CuttingPlane>& cut, int texels);
  /// Sets the uniforms of lamp_light.glsl for the maps that were drawn last. The program must be in use.
  void set(const gl::Program& program, const CameraView& camera, int unit) const;
  /// Sets the uniforms so that there are no lamps.
  void setNone(const gl::Program& program, int unit) const;

 private:
  /// A square of parallel rays towards the lamp.
  struct Window {
    Vec3 middle{0};
    double halfMm = 1;

    bool operator==(const Window&) const = default;
  };
  /// A map as it was drawn.
  struct Map {
    Vec3 towards{0};
    Window window;

    bool operator==(const Map&) const = default;
  };
  using Windows = std::array<Window, 2>;  // of the whole mesh, of the sphere

  Status makeRoom(int lamps, int texels);
  void drawMap(const Map& map, int column, int row, const GpuMesh& mesh, const std::optional<CuttingPlane>& cut) const;

  gl::Program program_;
  gl::Texture heights_;  // a column for each lamp, a row for each window
  gl::Framebuffer target_;
  LampLight light_;
  Windows windows_;
  std::array<std::array<std::optional<Map>, 2>, kMaxLights> drawn_;
};

}  // namespace qrelief
