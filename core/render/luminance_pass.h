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

/// Sampling of the light that a cell receives.
struct LuminanceSampling {
  int computedTexels = 2;  ///< along a cell's edge; rounded up to a divisor of cellTexels
  int slices = 10;         ///< pairs of half-planes per texel, ≥ 1
};

struct LuminanceOptions {
  int cellTexels = 4;  ///< along a cell's edge; the map's edge is a whole number of cells
  LuminanceSampling sampling = {};
  bool turnSlices = true;      ///< texels of a 4×4 block take different slices: for cell means, not for pictures
  float radiusMm = 5;          ///< reach of the march; beyond it, only the uncarved surface's horizon counts
  float everyBorderMm = 1e6f;  ///< the march stops at every cell border up to this distance, then at growing steps
  float reliefMm = 0;          ///< depth of pockets in the maps' own surface, in addition to setDepths()
  int horizonSamples = 64;     ///< points along the map's edge at which the uncarved surface's horizon is found, ≥ 1
  float horizonStartMm = 1;    ///< the horizon ignores surface nearer than this; the march covers it
  float albedo = 0.7f;         ///< of the material, 0 … 1; about 0.7 for white plastic
  std::vector<DirectionalLight> lights = {};  ///< at most kMaxLights
};

/// Programs that every LuminancePass and every FloorPasses of a GL context can share. Software renderers compile each
/// program to machine code anew.
struct LuminancePrograms {
  gl::Program horizon, occlusion, reduction, lighting;
  gl::Program floorDifference, floorSolution, floorDepth, floorRecord;  // render/floor_passes.h

  static Result<std::shared_ptr<const LuminancePrograms>> create();
};

/// Luminance of an engraved distance map under a uniform sky and lamps, in three passes: horizon-based occlusion and
/// shadows, reduction to one mean per cell, and lighting with interreflection [Papp 2022, §7]. 1 = an unoccluded
/// surface in the QR plane. The horizon of the uncarved surface, far and near, is found once, at creation.
///
/// Cost: computed texels of the selected cells × (2·slices + lamps) × cells marched over, until no rim can matter.
class LuminancePass {
 public:
  /// @param maps          kept by reference: they must outlive the pass
  /// @param surroundings  the surface around the maps from the same eye, in a wider window; may be null
  /// @param programs      null: makes its own
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

  void run() { run(depths_, false); }
  /// Runs with the depths of floors that a shader carves (FloorPasses::floors).
  /// @param onlyDue  compute only floors that moved last time or touch one that did; the others keep their luminance
  void runOnFloors(const gl::Texture& floors, bool onlyDue) { run(floors, onlyDue); }
  std::vector<float> readLuminance() const;    ///< mean of each cell, row-major from the lower left
  std::vector<Received> readReceived() const;  ///< mean of each cell, in the same order
  /// Restores the light that cells have received, as returned by readReceived(). The next run() updates the selected
  /// cells.
  void setReceived(std::span<const Received> received);
  const gl::Texture& luminance() const { return luminance_; }  ///< R32F, one texel per cell
  const gl::Texture& depths() const { return depths_; }
  const std::shared_ptr<const LuminancePrograms>& programs() const { return programs_; }

 private:
  Status findHorizon(const SurfaceMaps* surroundings);
  void run(const gl::Texture& depths, bool onlyDue);
  void setMap(const gl::Program& program, const gl::Texture& depths) const;
  void setLamps(const gl::Program& program) const;
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
