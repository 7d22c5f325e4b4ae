// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "light/directional_light.h"
#include "light/far_horizon.h"
#include "light/height_map.h"
#include "light/received.h"

namespace qrelief {

struct LightSampling {
  int points = 2;       ///< receiving points along a patch's edge, ≥ 1
  int directions = 20;  ///< around each point, ≥ 4; turned from one point to the next
};

struct LightOptions {
  LightSampling sampling = {};
  double reachMm = 5;                        ///< farther surface counts only through the far horizon
  double everyPatchMm = 1e6;                 ///< checks every patch border up to here, and at growing steps beyond
  std::vector<DirectionalLight> lamps = {};  ///< at most kMaxLights
  double lampRadiusDeg = 0;                  ///< radius of the lamps' discs; sets how soft shadows are
};

/// Light of a uniform sky and of lamps on a height map whose patches may be carved. Finds the horizon of every point in
/// each direction, exactly up to `everyPatchMm`. Integrates the cosine-weighted sky over it in closed form
/// [Jimenez 2016].
///
/// All patches of a row take the same steps to their horizons, so a vector holds up to 16 neighbouring patches
/// [Highway]. Rows run on all cores. Results are the same bits on every machine.
///
/// Cost: patches × points² × directions × patch borders within reach.
class HeightLight {
 public:
  /// @param far       horizon of the surface beyond reach; none: no surface there
  /// @param quarters  the same surface in patches half as wide. With two by two points in a patch, each point lies on
  ///                  its quarter. None: all points lie on the patches
  explicit HeightLight(const HeightMap& map, std::optional<FarHorizon> far = std::nullopt,
                       const std::optional<HeightMap>& quarters = std::nullopt);

  int size() const { return size_; }

  /// Sets the carving depth of each patch along its ray, mm, row-major from the lower left. All depths are zero at
  /// first.
  void carve(std::span<const float> depthsMm);

  /// Measures the light that patches receive.
  /// @param mask   not 0 for patches to measure; empty: all
  /// @param light   size² values, or empty; other patches keep their values
  void measure(const LightOptions& options, std::span<const std::uint8_t> mask, std::vector<Received>& light) const;

  /// Returns the luminance of every patch under sky and lamps with reflected light, 1 = an unoccluded surface in the QR
  /// plane. Reflected light comes from the surface that hides the sky; `light` gives its brightness.
  /// @param light     of all patches, by measure() with the same options
  /// @param albedo    of the material, 0 … 1
  std::vector<float> luminance(const LightOptions& options, std::span<const Received> light, double albedo) const;

 private:
  // Pieces of the surface, one in each patch, in rows padded on both sides.
  struct Pieces {
    Vec2 middle{0.5};  // in the patch, 0 … 1
    std::vector<float> uncarved, height, slopeX, slopeY;
  };
  template <class Piece>
  Pieces piecesOf(const HeightMap& map, Vec2 middle, const Piece& pieceOf) const;
  void carve(Pieces& pieces, std::span<const float> depthsMm) const;
  template <class Visit>
  void forEachRow(const LightOptions& options, std::span<const std::uint8_t> mask, const Visit& visit) const;

  int size_ = 0, stride_ = 0;  // of a padded row
  double patchMm_ = 0, eyeDistance_ = 250;
  bool isContinuous_ = false;
  std::optional<FarHorizon> far_;
  Pieces patches_;
  std::vector<Pieces> quarters_;  // row-major from the lower left; four or none
  float highest_ = 0;
  std::vector<std::uint8_t> isCarved_;
};

}  // namespace qrelief
