// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/result.h"
#include "gl/objects.h"
#include "light/directional_light.h"
#include "light/received.h"
#include "render/geometry_pass.h"

namespace qrelief {

/// Where the light of a cell is looked for.
struct LuminanceSampling {
  int computedTexels = 2;  ///< along a cell's edge; more, up to all, where it does not divide the cell
  int slices = 10;         ///< pairs of half-planes per texel, ≥ 1
};

struct LuminanceOptions {
  int cellTexels = 4;  ///< texels along a cell's edge; the map's edge is a whole number of cells
  LuminanceSampling sampling = {};
  bool turnSlices = true;      ///< texels of a 4×4 block take different slices: for cell means; false for pictures
  float radiusMm = 5;          ///< reach of the march; what lies farther counts by the surface's own horizon
  float everyBorderMm = 1e6f;  ///< up to here the march stops at every cell border; beyond, at steps that grow
  float reliefMm = 0;          ///< depth of what is carved into the maps' own surface, beside `setDepths`
  int horizonSamples = 64;     ///< places along the map's edge for which the surface's own horizon is found, ≥ 1
  float horizonStartMm = 1;    ///< surface nearer than this is left to the march
  float albedo = 0.7f;         ///< of the material, 0 … 1; white plastic is about 0.7
  std::vector<DirectionalLight> lights = {};  ///< at most kMaxLights
};

/// What every LuminancePass of a GL context may share: software renderers make machine code of each anew.
struct LuminancePrograms {
  gl::Program horizon, occlusion, reduction, lighting;

  static Result<std::shared_ptr<const LuminancePrograms>> create();
};

/// Luminance of an engraved distance map under a uniform sky and lamps, in three passes: horizon-based occlusion and
/// shadows, the reduction to one mean a cell, and lighting with interreflection [Papp 2022, §7]. 1 = an unoccluded
/// surface in the QR plane. Once, when it is made: the horizon of the uncarved surface, far and near.
///
/// Cost: computed texels of the listed cells × (2·slices + lamps) × cells up to where no rim can matter.
class LuminancePass {
 public:
  /// @param maps          kept by reference: they must outlive the pass
  /// @param surroundings  the model's further surface from the same eye, in a wider window; may be null
  /// @param programs      null: of its own
  static Result<LuminancePass> create(const SurfaceMaps& maps, const SurfaceMaps* surroundings, double eyeDistance,
                                      const LuminanceOptions& options,
                                      std::shared_ptr<const LuminancePrograms> programs = nullptr);

  int cellsAlongEdge() const { return cells_; }

  /// Sets the carving depth of every cell, mm, row-major from the map's lower left. All zero at first.
  void setDepths(std::span<const float> depthsMm);
  void setRadius(float radiusMm) { options_.radiusMm = radiusMm; }

  void setSampling(LuminanceSampling sampling) { options_.sampling = sampling; }

  /// Chooses the cells that `run` computes; the others keep their luminance. All cells at first.
  /// @param cells  indices, row-major from the lower left; at least one
  void selectCells(std::span<const std::uint32_t> cells);

  void run();
  std::vector<float> readLuminance() const;    ///< means of the cells², row-major from the lower left
  std::vector<Received> readReceived() const;  ///< likewise
  /// Takes back what cells have received, as `readReceived` gave it; the next `run` adds the chosen cells to it.
  void setReceived(std::span<const Received> received);
  const gl::Texture& luminance() const { return luminance_; }  ///< R32F, one texel a cell
  const gl::Texture& depths() const { return depths_; }

 private:
  Status findHorizon(const SurfaceMaps* surroundings);
  void setMap(const gl::Program& program) const;
  int computedTexels() const;  // along a cell's edge
  int listed() const { return selected_ == cells_ * cells_ ? 0 : selected_; }
  int listRows() const { return (selected_ + cells_ - 1) / cells_; }

  const SurfaceMaps* maps_ = nullptr;
  double eyeDistance_ = 250;
  LuminanceOptions options_;
  int cells_ = 0;
  std::shared_ptr<const LuminancePrograms> programs_;
  gl::Texture horizon_, list_, depths_, received_, means_, luminance_;
  gl::Framebuffer receivedTarget_, meansTarget_, luminanceTarget_;
  gl::VertexArray cellArray_;
  gl::Buffer cellBuffer_;
  GLsizei selected_ = 0;
};

}  // namespace qrelief
