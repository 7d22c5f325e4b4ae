// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "gl/objects.h"
#include "render/geometry_pass.h"

namespace qrelief {

struct LuminanceOptions {
  int cellTexels = 4;      ///< texels along a cell's edge; the map's edge is a whole number of cells
  int slices = 4;          ///< pairs of half-planes per texel, ≥ 1
  bool turnSlices = true;  ///< texels of a 4×4 block take different slices: for cell means; false for pictures
  float radiusMm = 5;      ///< reach of the occlusion
  float albedo = 0.7f;     ///< of the material, 0 … 1; white plastic is about 0.7
};

/// Luminance of an engraved distance map under a uniform sky, in three passes: horizon-based occlusion, lighting with
/// interreflection, and the reduction to one mean a cell [Papp 2022, §7]. 1 = unoccluded plane.
///
/// Cost: texels of the listed cells × 2·slices × cells within the radius.
class LuminancePass {
 public:
  /// @param maps  kept by reference: they must outlive the pass
  static Result<LuminancePass> create(const SurfaceMaps& maps, double eyeDistance, const LuminanceOptions& options);

  int cellsAlongEdge() const { return cells_; }

  /// Sets the carving depth of every cell, mm, row-major from the map's lower left. All zero at first.
  void setDepths(std::span<const float> depthsMm);
  void setRadius(float radiusMm) { options_.radiusMm = radiusMm; }

  /// Chooses the cells that `run` computes; the others keep their luminance. All cells at first.
  /// @param cells  indices, row-major from the lower left
  void selectCells(std::span<const std::uint32_t> cells);

  void run();
  std::vector<float> readCellMeans() const;   ///< cells², row-major from the lower left
  std::vector<float> readLuminance() const;   ///< texels², row-major from the lower left
  std::vector<float> readVisibility() const;  ///< texels², row-major from the lower left
  const gl::Texture& luminance() const { return luminance_; }
  const gl::Texture& depths() const { return depths_; }

 private:
  const SurfaceMaps* maps_ = nullptr;
  double eyeDistance_ = 250;
  LuminanceOptions options_;
  int cells_ = 0;
  float highestMm_ = 0;
  gl::Program occlusion_, lighting_, reduction_;
  gl::Texture depths_, visibility_, luminance_, means_;
  gl::Framebuffer visibilityTarget_, luminanceTarget_, meansTarget_;
  gl::VertexArray cellArray_;
  gl::Buffer cellBuffer_;
  GLsizei selected_ = 0;
};

}  // namespace qrelief
