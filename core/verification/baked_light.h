// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/grid.h"
#include "math/frame.h"
#include "verification/ink.h"
#include "verification/light_path.h"

namespace qrelief {

/// Light that a matte surface reflects, equal in all directions. 1 = an unoccluded surface under the sky alone.
struct SurfaceLight {
  double sky = 0;   ///< under the sky alone, all bounces
  double lamp = 0;  ///< light added by the lamps, all bounces
};

/// Number of rows that a job bakes in one step. A job can be cancelled between two steps.
inline constexpr int kRowsAStep = 16;

struct BakeOptions {
  double texelMm = 0.1;  ///< edge of a texel on the QR plane
  int texels = 400;      ///< along the edge of the baked square, which is centred on the code
  int border = 0;        ///< width in texels of a strip along each edge that is not baked, as if the rays missed the
                         ///< model
  bool isTraced = true;  ///< false: setLight() supplies the light that the eye sees, and only other light is traced
  int paths = 16;        ///< light paths per texel, ≥ 1
  double albedo = 0.7;   ///< reflectance of the matte material, 0 … 1
  std::vector<Lamp> lamps = {};
};

/// Luminance of the background, as a fraction of an unoccluded surface's luminance.
inline constexpr float kBackground = 0.35f;

/// Square linear picture, 1 = an unoccluded surface under the sky alone. Pixels off the model have kBackground of the
/// open light.
struct LinearPicture {
  BottomUp<float> sky;    ///< light of the sky
  BottomUp<float> added;  ///< light added by the lamps
};

/// The light on a carved surface, path-traced once on the mesh itself and valid from every side. A matte surface looks
/// the same from everywhere, so the picture of a tilted camera reuses the light found from the front. Surfaces hidden
/// from the front, usually the walls of pockets, are traced when a picture shows them.
///
/// Independent of the maps that carving works on: it uses only the mesh and the eye. Deterministic.
class BakedLight {
 public:
  /// @param surface  kept by reference
  BakedLight(const RaySurface& surface, const ProjectionFrame& frame, const BakeOptions& options);

  /// Bakes the next rows, on all cores.
  /// Cost: rows × texels × paths × (bounces + 1) rays each for sky and lamps.
  /// @returns true after the last row
  bool bakeRows(int rows);

  /// Sets the light of every texel if BakeOptions::isTraced is off. Call it after the last row.
  void setLight(BottomUp<SurfaceLight> light);

  /// Averages each texel with its neighbours on the same floor, which leaves a third of the noise. Call it once, after
  /// the last row.
  void smooth();

  /// Takes a picture with `texels` of `texelMm` along the edge of a square on the camera's own QR plane. Cost: a ray
  /// per texel, and the paths of those texels that the bake does not cover.
  /// @param camera  must have the code's centre
  /// @param ink     of a code in colour; null: the surface has one material
  LinearPicture picture(const ProjectionFrame& camera, int texels, double texelMm, const InkMap* ink = nullptr) const;

  /// Returns the light of the baked square; negative where rays miss the model.
  const BottomUp<SurfaceLight>& light() const { return light_; }
  const BakeOptions& options() const { return options_; }
  /// Returns the light of an unoccluded surface in the QR plane under sky and lamps.
  double openLight() const;

 private:
  struct Texel {
    Vec3 position{0};
    Vec3 normal{0};  ///< 0: the ray misses the model
  };

  void bakeTexel(int row, int column);
  SurfaceLight traced(const SurfacePoint& at, Vec3 seen, int row, int column) const;
  SurfaceLight lightAt(const SurfacePoint& at, Vec3 seen, int row, int column) const;

  const RaySurface* surface_;
  ProjectionFrame frame_;
  BakeOptions options_;
  BottomUp<Texel> texels_;
  BottomUp<SurfaceLight> light_;
  int baked_ = 0;
};

/// Returns a frame with the same eye distance and centre that leans by `tiltDeg` towards `azimuthDeg` (0 = right, 90 =
/// the symbol's top).
ProjectionFrame tilted(const ProjectionFrame& frame, double tiltDeg, double azimuthDeg);

}  // namespace qrelief
