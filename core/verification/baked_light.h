// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "math/frame.h"
#include "verification/light_path.h"

namespace qrelief {

/// What leaves a matte surface, the same in all directions. 1 = an unoccluded surface under the sky alone.
struct SurfaceLight {
  double sky = 0;   ///< under the sky alone, all bounces
  double lamp = 0;  ///< what the lamp adds, all bounces
};

/// Rows that a job bakes in one step: between two steps it can be cancelled.
inline constexpr int kRowsAStep = 16;

struct BakeOptions {
  double texelMm = 0.1;  ///< on the QR plane
  int texels = 400;      ///< along the edge of the square that is baked, centred on the code
  int border = 0;        ///< so many texels along each edge are left out, as if the rays missed the model
  bool isTraced = true;  ///< else setLight() brings the light that the eye sees, and only other light is traced
  int paths = 16;        ///< of traced light, a texel, ≥ 1
  double albedo = 0.7;   ///< of the matte material, 0 … 1
  Lamp lamp = {};
};

/// Luminance of what is not the model, as a fraction of an unoccluded surface's.
inline constexpr float kBackground = 0.35f;

/// Linear picture, 1 = an unoccluded surface under the sky alone; row 0 at the bottom. What is no model is kBackground
/// of the open light.
struct LinearPicture {
  int width = 0;             ///< = height
  std::vector<float> sky;    ///< under the sky alone
  std::vector<float> added;  ///< by the lamp
};

/// The light on a carved surface, computed once by path tracing the mesh itself and seen from anywhere: a matte surface
/// looks the same from every side, so a tilted reader's picture takes the light that was found in front. What was not
/// seen there, the walls of the pockets as a rule, is traced when a picture shows it.
///
/// Independent of the maps that carving works on: it knows the mesh, the eye and nothing else. Deterministic.
class BakedLight {
 public:
  /// @param surface  kept by reference
  BakedLight(const RaySurface& surface, const ProjectionFrame& frame, const BakeOptions& options);

  /// Bakes the next rows, on all cores. @returns whether that was the last
  /// Cost: rows × texels × paths × (bounces + 1) rays each for sky and lamp.
  bool bakeRows(int rows);

  /// Light found otherwise, of every texel; after the last row, where BakeOptions::isTraced is off.
  void setLight(std::vector<SurfaceLight> light);

  /// Averages each texel with its neighbours on the same floor, which leaves a third of the noise. Once, after the last
  /// row.
  void smooth();

  /// What a camera sees at `texels` of `texelMm` along the edge of a square on its own QR plane. Cost: a ray a texel,
  /// and the paths of the texels that show what the bake does not.
  /// @param camera  its centre is the code's
  LinearPicture picture(const ProjectionFrame& camera, int texels, double texelMm) const;

  /// Of the baked square, row-major from the lower left; negative where the model is missed.
  const std::vector<SurfaceLight>& light() const { return light_; }
  const BakeOptions& options() const { return options_; }
  /// Of an unoccluded surface in the QR plane under sky and lamp.
  double openLight() const;

 private:
  struct Texel {
    Vec3 position{0};
    Vec3 normal{0};  ///< 0: the ray misses the model
  };

  void bakeTexel(std::size_t texel);
  SurfaceLight traced(const SurfacePoint& at, Vec3 seen, int row, int column) const;
  SurfaceLight lightAt(const SurfacePoint& at, Vec3 seen, int row, int column) const;

  const RaySurface* surface_;
  ProjectionFrame frame_;
  BakeOptions options_;
  std::vector<Texel> texels_;
  std::vector<SurfaceLight> light_;
  int baked_ = 0;
};

/// The same eye distance and centre, leaning by `tiltDeg` towards `azimuthDeg` (0 = right, 90 = the symbol's top).
ProjectionFrame tilted(const ProjectionFrame& frame, double tiltDeg, double azimuthDeg);

}  // namespace qrelief
