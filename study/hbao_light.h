// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "light/height_light.h"
#include "pipeline/placement_light.h"

namespace qrelief::study {

/// Parameters of horizon-based ambient occlusion. Papp 2022 publishes no values. The defaults come nearest to path
/// tracing among the measured ones (experiments/hbao_light.cpp).
struct HbaoOptions {
  double radiusModules = 2;    ///< R: farther surface hides nothing, > 0
  double angleBiasDeg = 0;     ///< a horizon up to this angle over the tangent plane counts as open, 0 … 90
  int directions = 4;          ///< around each pixel, ≥ 1
  int steps = 4;               ///< samples along a direction, ≥ 1
  bool isAttenuated = true;    ///< occlusion fades linearly with distance, to nothing at R
  bool isJittered = true;      ///< turn the directions and shift the samples from pixel to pixel
  int pixelsPerSubmodule = 3;  ///< along a submodule's edge, ≥ 1
};

/// Light by horizon-based ambient occlusion in image space [Bavoil, Sainz, Dimitrov, "Image-space horizon-based ambient
/// occlusion", SIGGRAPH 2008 talks], as Papp 2022, §7 proposes it:
///
///     luminance = 1 − 1/N Σ_θ Σ_k W(r_k) (sin h_k − sin h_{k−1}),   W(r) = 1 − r/R
///
/// h_k is the highest horizon angle of the first k samples in direction θ, h_0 the tangent's plus the bias, r_k the
/// distance of the sample that raised it. Samples are equally spaced up to R, shifted by a random part of a step, and
/// snap to pixels. There is no reflected light. Lamps are Lambert terms with exact shadows (light/height_light.h).
///
/// A pixel is a part of a submodule; heights are those of the map (light/height_map.h).
class HbaoLight final : public PlacementLight {
 public:
  /// @param map      the uncarved surface, one patch per cell
  /// @param options  albedo is not used
  HbaoLight(HeightMap map, PlacementLightOptions options, const HbaoOptions& hbao);
  ~HbaoLight() override;

  /// Lets a shader in the current GL context compute the light of the sky from now on, for all cells at once. Only
  /// rounding differs.
  /// @returns Internal if the context refuses the shader
  Status useShader();

  std::vector<float> luminance(std::span<const std::uint32_t> cells, std::span<const float> depthsMm,
                               double reachMm) override;
  std::vector<Received> received() const override { return received_; }
  std::vector<float> uncarvedLuminance() const override { return luminancesOf(uncarved_); }
  void uncarve() override { received_ = uncarved_; }
  const gl::Texture& luminanceTexture() const override {
    return luminanceTexture_ = textureOf(luminancesOf(received_));
  }
  const gl::Texture& depthTexture() const override { return depthTexture_ = textureOf(depthsMm_); }

 private:
  struct Direction {
    Vec2 along{1, 0};
    std::vector<Vec2> samples;  // from a pixel's middle, mm
  };

  struct Shader;

  void carve(std::span<const float> depthsMm);
  double heightAt(Vec2 plane) const;
  double skyAt(Vec2 plane, std::size_t cell, const std::vector<Direction>& directions) const;
  void measureSky(std::size_t cell);
  void measureSkyByShader(std::span<const std::uint32_t> cells);
  std::vector<float> luminancesOf(const std::vector<Received>& received) const;
  gl::Texture textureOf(const std::vector<float>& values) const;

  HeightMap map_;
  PlacementLightOptions options_;
  HbaoOptions hbao_;
  double pixelMm_ = 1;
  std::vector<std::vector<Direction>> patterns_;  // of a tile of pixels
  std::vector<float> height_;                     // w of the carved cells' middles
  std::unique_ptr<Shader> shader_;                // null: the CPU computes the sky
  std::optional<HeightLight> lamps_;              // none: no lamps
  std::vector<Received> uncarved_, received_;
  std::vector<float> depthsMm_;
  mutable gl::Texture luminanceTexture_, depthTexture_;  // made when asked for
};

}  // namespace qrelief::study
