// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/placement_light.h"

#include <cassert>
#include <numeric>

#include "light/height_light.h"
#include "qr/module_pattern.h"

namespace qrelief {
namespace {

constexpr int kN = kSubmodulesPerModule;
constexpr int kHorizonsPerModule = 2;
constexpr double kFirstReachModules = 3;
constexpr LuminanceSampling kUncarvedSampling{1, 4};  // the surface is smooth but for the model's own edges
constexpr LightSampling kUncarvedPoints{1, 12}, kPoints{2, 12};
constexpr double kEveryCell = 12;  // up to this distance a horizon checks every cell

/// Returns the places per module whose horizon the processor finds: the shadow of a lamp ends more sharply than the
/// sky.
int horizonsPerModule(const PlacementLightOptions& options) { return options.lamps.empty() ? 1 : kHorizonsPerModule; }

std::vector<float> luminancesOf(std::span<const Received> received, const PlacementLightOptions& options) {
  const auto open = static_cast<float>(openIrradiance(options.lamps));
  std::vector<float> luminance;
  luminance.reserve(received.size());
  for (const Received& cell : received) luminance.push_back(luminanceOf(cell, options.albedo, open));
  return luminance;
}

class LightByShaders final : public PlacementLight {
 public:
  LightByShaders(LuminancePass pass, PlacementLightOptions options)
      : pass_(std::move(pass)), options_(std::move(options)) {}

  /// Lights the surroundings, once: pockets lie below the light modules and hide no sky from them.
  void lightUncarved(double moduleMm) {
    pass_.setSampling(kUncarvedSampling);
    pass_.setRadius(static_cast<float>(moduleMm));  // the horizon covers the rest
    pass_.run();
    pass_.setSampling({});
    uncarved_ = pass_.readReceived();
  }

  std::vector<float> luminance(std::span<const std::uint32_t> cells, std::span<const float> depthsMm,
                               double reachMm) override {
    pass_.selectCells(cells);
    pass_.setDepths(depthsMm);
    pass_.setRadius(static_cast<float>(reachMm));
    pass_.run();
    return pass_.readLuminance();
  }
  std::vector<Received> received() const override { return pass_.readReceived(); }
  std::vector<float> uncarvedLuminance() const override { return luminancesOf(uncarved_, options_); }
  LuminancePass* shaders() override { return &pass_; }
  void uncarve() override { pass_.setReceived(uncarved_); }
  const gl::Texture& luminanceTexture() const override { return pass_.luminance(); }
  const gl::Texture& depthTexture() const override { return pass_.depths(); }

 private:
  LuminancePass pass_;
  PlacementLightOptions options_;
  std::vector<Received> uncarved_;
};

class LightByProcessor final : public PlacementLight {
 public:
  LightByProcessor(const HeightMap& map, const HeightMap& around, const PlacementLightOptions& options,
                   const std::optional<HeightMap>& quarters)
      : options_(options),
        light_(
            map,
            farHorizonOf(map, &around, options.moduleMm, horizonsPerModule(options) * options.modules, options.lamps),
            quarters),
        size_(map.size),
        luminance_(map.height.size(), 0.0f),
        depthsMm_(map.height.size(), 0.0f) {
    light_.measure({.sampling = kUncarvedPoints, .reachMm = options.moduleMm, .lamps = options.lamps}, {}, uncarved_);
    for (Received& received : uncarved_) received.pastWalls = 1;
    received_ = uncarved_;
  }

  std::vector<float> luminance(std::span<const std::uint32_t> cells, std::span<const float> depthsMm,
                               double reachMm) override {
    assert(!cells.empty());
    light_.carve(depthsMm);
    std::vector<std::uint8_t> isMeasured(received_.size(), 0);
    for (const std::uint32_t cell : cells) isMeasured[cell] = 1;
    light_.measure({.sampling = kPoints,
                    .reachMm = reachMm,
                    .everyPatchMm = kEveryCell * options_.moduleMm / kN,
                    .lamps = options_.lamps},
                   isMeasured, received_);
    luminance_ = luminancesOf(received_, options_);
    depthsMm_.assign(depthsMm.begin(), depthsMm.end());
    return luminance_;
  }
  std::vector<Received> received() const override { return received_; }
  std::vector<float> uncarvedLuminance() const override { return luminancesOf(uncarved_, options_); }
  void uncarve() override { received_ = uncarved_; }
  const gl::Texture& luminanceTexture() const override { return luminanceTexture_ = textureOf(luminance_); }
  const gl::Texture& depthTexture() const override { return depthTexture_ = textureOf(depthsMm_); }

 private:
  gl::Texture textureOf(const std::vector<float>& values) const {
    return {size_, size_, gl::Format::R32F, values.data()};
  }

  PlacementLightOptions options_;
  HeightLight light_;
  std::vector<Received> uncarved_, received_;
  int size_;  // of the map, in cells
  std::vector<float> luminance_, depthsMm_;
  mutable gl::Texture luminanceTexture_, depthTexture_;  // made when asked for
};

}  // namespace

Result<std::unique_ptr<PlacementLight>> lightByShaders(const SurfaceMaps& maps, const SurfaceMaps& around,
                                                       double eyeDistance, const PlacementLightOptions& options,
                                                       std::shared_ptr<const LuminancePrograms> programs) {
  LuminanceOptions luminance;
  luminance.cellTexels = maps.window.texels / (kN * options.modules);
  luminance.albedo = options.albedo;
  luminance.lights = options.lamps;
  luminance.horizonSamples = kHorizonsPerModule * options.modules;
  luminance.horizonStartMm = static_cast<float>(options.moduleMm);
  luminance.radiusMm = static_cast<float>(kFirstReachModules * options.moduleMm);
  auto pass = LuminancePass::create(maps, &around, eyeDistance, luminance, std::move(programs));
  QRELIEF_TRY(pass);
  auto light = std::make_unique<LightByShaders>(std::move(*pass), options);
  light->lightUncarved(options.moduleMm);
  return light;
}

std::unique_ptr<PlacementLight> lightByProcessor(const HeightMap& map, const HeightMap& around,
                                                 const PlacementLightOptions& options,
                                                 const std::optional<HeightMap>& quarters) {
  return std::make_unique<LightByProcessor>(map, around, options, quarters);
}

}  // namespace qrelief
