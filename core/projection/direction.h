// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "math/frame.h"
#include "render/geometry_pass.h"

namespace qrelief {

enum class DirectionMethod {
  MeanNormal,     ///< mean of the surface's normals [Papp 2022, §3, first method]
  DepthBalanced,  ///< the distance to the reader's eye varies little [Papp 2022, §3, second method]
  Pca,            ///< axis along which points of the surface vary least [Kikuchi et al. 2018]
  Optimal         ///< from DepthBalanced's answer on, see optimal_direction.h
};

/// "mean-normal", "depth-balanced", "pca", "optimal": names that scripts rely on.
const char* directionMethodName(DirectionMethod method);

struct DirectionOptions {
  DirectionMethod method = DirectionMethod::DepthBalanced;
  double sizeMm = 35;       ///< edge of the sampled square, > 0
  int samples = 1024;       ///< Halton points of the map
  int grid = 8;             ///< cells along the edge of the depth grid, ≥ 2
  int maxIterations = 5;    ///< updates of the direction
  double variance = 0.002;  ///< stop when the variance of the distance is ≤ this · sizeMm²: 0.05 cm² at 5 cm
  int mapTexels = 256;
  double eyeDistanceMm = 250;  ///< from the centre, > 0
};

/// What one rendering from one direction said.
struct DirectionIteration {
  Vec3 normal;                 ///< the direction looked from, unit, towards the reader
  double varianceMm2 = 0;      ///< variance of the distance over the texels that meet the model
  double outsideFraction = 0;  ///< of the texels, 0 … 1
  double worstAngle = 0;       ///< see MapSample
  double measure = 0;          ///< see MapSample
};

/// What a pair of maps says of the direction it was rendered from. Vectors in the axes of the frame, each unit or zero.
struct MapSample {
  Vec3 mean{0};           ///< step 1: over all Halton samples
  Vec3 depthBalance{0};   ///< step 2: over the cells of the two largest and two smallest mean distances, ties included
  Vec3 outside{0};        ///< step 3: over the cells wholly outside the silhouette; zero if there is none
  Vec3 leastVariance{0};  ///< principal axis of the Halton samples' surface points that varies least, towards the eye
  double varianceMm2 = 0;
  double outsideFraction = 0;
  bool centreIsSeen = false;  ///< nothing is nearer to the eye, by more than a few texels, than the centre

  /// Angle (radians) at which the twentieth of the square that is seen most obliquely is seen: between the facets'
  /// normals and the lines to the eye, by the mean of the cosines; 0 = frontal, π/2 = edge-on, or outside.
  double worstAngle = 0;

  /// How badly a code reads from here, without unit: variance/s² + kObliqueWeight·(1 - cos worstAngle), where variance
  /// is that of the distance and a texel outside the silhouette counts as lying s/2 off the mean. 0 = a flat surface
  /// looked at frontally from far away. This is what DirectionMethod::Optimal minimises.
  double measure = 0;
};

/// Weight of the worst angle in `MapSample::measure`: to turn by 10° towards a facet that is seen at 60° is worth the
/// variance that a plane tilted by 10° has, tan²(10°)/12.
inline constexpr double kObliqueWeight = 0.02;

/// Samples a normal and distance map [Papp 2022, §3]. A texel outside the silhouette counts with the normal
/// normalise((B - C)/(s/2) - n̂), which turns an overhanging square back towards the body.
/// @param normals  texels² of (unit normal, distance in mm), row 0 at the bottom; distance 0 = outside
MapSample sampleMap(std::span<const float> normals, int texels, const DirectionOptions& options);

/// How a surface map (SurfaceMaps::surface, texels² of it) of a window is had.
using SurfaceLook = std::function<Result<std::vector<float>>(const ProjectionFrame& frame, const MapWindow& window)>;

/// Rendered by the GPU and read back.
/// @param pass, mesh  kept by reference
SurfaceLook lookByRendering(const GeometryPass& pass, const GpuMesh& mesh);

/// Looks at the square that a frame defines and samples it, with the frame's eye distance.
Result<MapSample> lookFrom(const SurfaceLook& look, const ProjectionFrame& frame, const DirectionOptions& options);
Result<MapSample> lookFrom(const GeometryPass& pass, const GpuMesh& mesh, const ProjectionFrame& frame,
                           const DirectionOptions& options);

/// Direction of projection by sampling the surface [Papp 2022, §3], one rendering a step.
///
/// MeanNormal: the mean of the map's normals, once. Pca: the axis along which the sampled surface points vary least,
/// once. DepthBalanced, and Optimal, whose first part it is: the mean of the steps' vectors, repeated until the
/// distance varies little (from the second time on by half a step, as full ones swing); if it never does, the direction
/// it varied least from.
class DirectionSearch {
 public:
  /// @param surfaceNormal  at the centre, any length > 0
  /// @param eyeDistance    instead of the options'
  DirectionSearch(SurfaceLook look, Vec3 centre, Vec3 surfaceNormal, Vec3 upHint, double eyeDistance,
                  const DirectionOptions& options);
  /// @param pass, mesh     kept by reference
  DirectionSearch(const GeometryPass& pass, const GpuMesh& mesh, Vec3 centre, Vec3 surfaceNormal, Vec3 upHint,
                  double eyeDistance, const DirectionOptions& options);

  /// Looks from the current direction once. @returns true when the search is over
  Result<bool> step();

  Vec3 normal() const { return best_; }
  const std::vector<DirectionIteration>& iterations() const { return iterations_; }

 private:
  SurfaceLook look_;
  Vec3 centre_, upHint_, current_, best_;
  double eyeDistance_;
  DirectionOptions options_;
  std::vector<DirectionIteration> iterations_;
};

}  // namespace qrelief
