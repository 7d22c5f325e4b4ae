// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "math/frame.h"
#include "render/surface_renderer.h"

namespace qrelief {

enum class DirectionMethod {
  MeanNormal,     ///< mean of the surface's normals [Papp 2022, §3, first method]
  DepthBalanced,  ///< the distance to the eye varies little [Papp 2022, §3, second method]
  Pca,            ///< axis along which surface points vary least [Kikuchi et al. 2018]
  Optimal,        ///< refines DepthBalanced's answer, see optimal_direction.h
  Largest         ///< the largest code near DepthBalanced's answer, see pipeline/placement.h; for found sizes only
};

/// Returns "mean-normal", "depth-balanced", "pca", "optimal" or "largest". Scripts rely on these names.
const char* directionMethodName(DirectionMethod method);

struct DirectionOptions {
  DirectionMethod method = DirectionMethod::DepthBalanced;
  double sizeMm = 35;       ///< edge of the sampled square, > 0
  int samples = 1024;       ///< Halton points of the map
  int grid = 8;             ///< cells along the edge of the depth grid, ≥ 2
  int maxIterations = 5;    ///< limit on updates of the direction
  double variance = 0.002;  ///< stop when the variance of the distance is ≤ this · sizeMm²: 0.05 cm² at 5 cm
  int mapTexels = 256;
  double eyeDistanceMm = 250;  ///< from the centre, > 0
};

/// Measurements of one rendering from one direction.
struct DirectionIteration {
  Vec3 normal;                 ///< viewing direction, unit, towards the viewer
  double varianceMm2 = 0;      ///< variance of the distance over the texels that meet the model
  double outsideFraction = 0;  ///< fraction of the texels off the model, 0 … 1
  double worstAngle = 0;       ///< see MapSample
  double measure = 0;          ///< see MapSample
};

/// Directions and ratings derived from one normal and distance map. Vectors are in the axes of the frame, each unit or
/// zero.
struct MapSample {
  Vec3 mean{0};  ///< step 1: mean normal of all Halton samples
  /// Step 2: mean normal of the cells with the two largest and the two smallest mean distances, ties included.
  Vec3 depthBalance{0};
  Vec3 outside{0};        ///< step 3: mean normal of the cells wholly outside the silhouette; zero if there is none
  Vec3 leastVariance{0};  ///< principal axis along which the Halton samples' surface points vary least, towards the eye
  double varianceMm2 = 0;
  double outsideFraction = 0;
  bool centreIsSeen = false;  ///< nothing is nearer to the eye than the centre by more than a few texels

  /// Angle (radians) between facet normals and lines to the eye; its cosine is the mean cosine over the most oblique
  /// twentieth of the square. 0 = frontal; π/2 = edge-on, or outside.
  double worstAngle = 0;

  /// Badness of the direction, without unit: variance/s² + kObliqueWeight·(1 - cos worstAngle). The variance is that of
  /// the distance; a texel outside the silhouette counts as s/2 off the mean. 0 = a flat surface seen frontally from
  /// far away. DirectionMethod::Optimal minimises this measure.
  double measure = 0;
};

/// Weight of the worst angle in `MapSample::measure`: turning by 10° towards a facet that is seen at 60° weighs as much
/// as the variance of a plane tilted by 10°, tan²(10°)/12.
inline constexpr double kObliqueWeight = 0.02;

/// Samples a normal and distance map [Papp 2022, §3]. A texel outside the silhouette gets the normal normalise((B -
/// C)/(s/2) - n̂), which turns an overhanging square back towards the body.
/// @param normals  texels² values of (unit normal, distance in mm), row 0 at the bottom; distance 0 = outside
MapSample sampleMap(std::span<const float> normals, int texels, const DirectionOptions& options);

/// Samples the square that a frame defines, from the frame's eye distance.
Result<MapSample> lookFrom(const SurfaceRenderer& surface, const ProjectionFrame& frame,
                           const DirectionOptions& options);

/// Search for the direction of projection by sampling the surface [Papp 2022, §3], one rendering per step.
///
/// MeanNormal takes the mean of the map's normals, once. Pca takes the axis along which the sampled surface points vary
/// least, once. DepthBalanced, which is also the first part of Optimal, repeatedly takes the mean of the three steps'
/// vectors until the distance varies little. From the second update on it goes half the way, because full updates
/// oscillate. If the distance never varies little enough, the direction with the least variance wins.
class DirectionSearch {
 public:
  /// @param surface        kept by reference
  /// @param surfaceNormal  at the centre, any length > 0
  /// @param eyeDistance    replaces the one in the options
  DirectionSearch(const SurfaceRenderer& surface, Vec3 centre, Vec3 surfaceNormal, Vec3 upHint, double eyeDistance,
                  const DirectionOptions& options);

  /// Renders once from the current direction. @returns true when the search is over
  Result<bool> step();

  Vec3 normal() const { return best_; }
  const std::vector<DirectionIteration>& iterations() const { return iterations_; }

 private:
  const SurfaceRenderer* surface_;
  Vec3 centre_, upHint_, current_, best_;
  double eyeDistance_;
  DirectionOptions options_;
  std::vector<DirectionIteration> iterations_;
};

}  // namespace qrelief
