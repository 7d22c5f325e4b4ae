// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "depth/light_neighbours.h"
#include "gl/objects.h"
#include "light/far_horizon.h"
#include "light/received.h"
#include "qr/module_pattern.h"
#include "qr/symbol.h"
#include "render/luminance_pass.h"

namespace qrelief {

/// Layout of the symbol's submodules in a map of cells with a margin all round; one cell is one submodule.
struct CellLayout {
  int modules = 0;  ///< along the symbol's edge
  static constexpr int kN = kSubmodulesPerModule;

  bool operator==(const CellLayout&) const = default;

  int cells() const { return kN * (modules + 2 * (kQuietZoneModules + kOcclusionMarginModules)); }
  /// @param row, column  from the quiet zone's top left; maps count rows from the bottom
  std::uint32_t ofQuietZone(int row, int column) const {
    const int offset = kN * kOcclusionMarginModules;
    return static_cast<std::uint32_t>((cells() - 1 - (row + offset)) * cells() + column + offset);
  }
  std::uint32_t ofSymbol(int row, int column) const {
    return ofQuietZone(row + kN * kQuietZoneModules, column + kN * kQuietZoneModules);
  }
};

/// Light on a place of a model while its cells (one per submodule) are carved to different depths. Cells are row-major
/// from the lower left; luminance 1 = an unoccluded surface in the QR plane.
class PlacementLight {
 public:
  virtual ~PlacementLight() = default;

  /// Measures some cells anew and returns the luminance of all.
  /// @param cells     cells to measure, at least one
  /// @param depthsMm  depths of all cells
  /// @param reachMm   beyond this distance only the uncarved place's horizon counts
  virtual std::vector<float> luminance(std::span<const std::uint32_t> cells, std::span<const float> depthsMm,
                                       double reachMm) = 0;
  /// Returns the light of all cells, as last measured.
  virtual std::vector<Received> received() const = 0;
  /// Returns the luminance of all cells before carving.
  virtual std::vector<float> uncarvedLuminance() const = 0;
  /// Returns the pass that computes the light on a GPU, for a search that needs no luminances on the CPU; null if the
  /// CPU computes it.
  virtual LuminancePass* shaders() { return nullptr; }
  /// Resets all depths to zero.
  virtual void uncarve() = 0;
  /// Return textures for the inspector; R32F, one texel per cell. Need a current GL context.
  virtual const gl::Texture& luminanceTexture() const = 0;
  virtual const gl::Texture& depthTexture() const = 0;
};

struct PlacementLightOptions {
  int modules = 0;      ///< along the map's edge, margin included
  double moduleMm = 1;  ///< on the QR plane
  float albedo = 0.7f;
  std::vector<DirectionalLight> lamps = {};
};

/// Makes a PlacementLight that uses shaders on a GPU [LuminancePass].
/// @param maps, around  see LuminancePass::create
Result<std::unique_ptr<PlacementLight>> lightByShaders(const SurfaceMaps& maps, const SurfaceMaps& around,
                                                       double eyeDistance, const PlacementLightOptions& options,
                                                       std::shared_ptr<const LuminancePrograms> programs);

/// Makes a PlacementLight that uses the CPU [HeightLight].
/// @param map       the uncarved surface, one patch per cell
/// @param around    the surface around it, in a wider window
/// @param quarters  see HeightLight
std::unique_ptr<PlacementLight> lightByProcessor(const HeightMap& map, const HeightMap& around,
                                                 const PlacementLightOptions& options,
                                                 const std::optional<HeightMap>& quarters = std::nullopt);

}  // namespace qrelief
