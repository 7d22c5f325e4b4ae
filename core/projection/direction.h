// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "base/result.h"
#include "math/frame.h"
#include "render/geometry_pass.h"

namespace qrelief {

enum class DirectionMethod { MeanNormal, DepthBalanced };

struct DirectionOptions {
  DirectionMethod method = DirectionMethod::DepthBalanced;
  double sizeMm = 35;       ///< edge of the sampled square, > 0
  int samples = 1024;       ///< Halton points of the map
  int grid = 8;             ///< cells along the edge of the depth grid, ≥ 2
  int maxIterations = 5;    ///< updates of the direction
  double variance = 0.002;  ///< stop when the variance of the distance is ≤ this · sizeMm²: 0.05 cm² at 5 cm
  int mapTexels = 256;
};

/// What one rendering from one direction said.
struct DirectionIteration {
  Vec3 normal;              ///< the direction looked from, unit, towards the reader
  double varianceMm2 = 0;   ///< of the distance over the texels that meet the model
  double outsideShare = 0;  ///< of the texels, 0 … 1
};

/// Mean normals that a pair of maps gives, in the axes of the frame it was rendered with; each unit or zero.
struct MapSample {
  Vec3 mean{0};          ///< step 1: over all Halton samples
  Vec3 depthBalance{0};  ///< step 2: over the cells of the two largest and two smallest mean distances, ties included
  Vec3 outside{0};       ///< step 3: over the cells wholly outside the silhouette; zero if there is none
  double varianceMm2 = 0;
  double outsideShare = 0;
};

/// Samples a normal and distance map [Papp 2022, §3]. A texel outside the silhouette counts with the normal
/// normalise((B - C)/(s/2) - n̂), which turns an overhanging square back towards the body.
/// @param normals  texels² of (unit normal, distance in mm), row 0 at the bottom; distance 0 = outside
MapSample sampleMap(std::span<const float> normals, int texels, const DirectionOptions& options);

/// Direction of projection by the paper's two methods [Papp 2022, §3], one rendering a step.
///
/// MeanNormal: the mean of the map's normals, once. DepthBalanced: the mean of the steps' vectors, repeated until the
/// distance varies little (from the second time on by half a step, as full ones swing); if it never does, the direction
/// it varied least from.
class DirectionSearch {
 public:
  /// @param pass, mesh     kept by reference
  /// @param surfaceNormal  at the centre, any length > 0
  DirectionSearch(const GeometryPass& pass, const GpuMesh& mesh, Vec3 centre, Vec3 surfaceNormal, Vec3 upHint,
                  double eyeDistance, const DirectionOptions& options);

  /// Looks from the current direction once. @returns true when the search is over
  Result<bool> step();

  Vec3 normal() const { return best_; }
  const std::vector<DirectionIteration>& iterations() const { return iterations_; }

 private:
  const GeometryPass* pass_;
  const GpuMesh* mesh_;
  Vec3 centre_, upHint_, current_, best_;
  double eyeDistance_;
  DirectionOptions options_;
  std::vector<DirectionIteration> iterations_;
};

}  // namespace qrelief
