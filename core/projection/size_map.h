// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "math/frame.h"
#include "mesh/topology.h"

namespace qrelief {

struct SizeMapOptions {
  double eyeDistanceMm = 250;  ///< from the bounding sphere to the eye, > 0
  double minMm = 10;  ///< smallest square of interest, > 0; sets the map's resolution and drops views that show less
  int views = 240;    ///< number of viewing directions, ≥ 1
  std::optional<Vec3> onlyFrom{};  ///< the only viewing direction, any length > 0; none: all around
  std::size_t facets = 24000;      ///< meshes with more facets are simplified to about this many, ≥ 100

  bool operator==(const SizeMapOptions&) const = default;
};

/// Size of the square that fits at each point of a model.
struct SizeMap {
  SizeMapOptions options;      ///< that it was made with
  Mesh mesh;                   ///< the model, simplified and with its long edges cut
  std::vector<Vec3f> normals;  ///< per vertex
  /// Edge of the largest square about each vertex that fits at every rotation in some view, mm; 0 if none fits.
  std::vector<float> sizeMm;
  std::vector<Vec3f> direction;  ///< per vertex: unit, towards the eye of that view; zero where no square fits
  bool isCoarser = false;        ///< true if simplified; else the model's vertices come first, unchanged
  /// Vertex of the map's mesh for each vertex of the model.
  std::vector<std::uint32_t> vertexOf;
  int viewsDropped = 0;  ///< views whose silhouette is smaller than the square
};

/// Returns a unit vector of an even distribution over the sphere: a spherical Fibonacci lattice [Swinbank, Purser
/// 2006].
/// @param index  0 … count - 1
Vec3 latticeDirection(int index, int count);

/// Search for the size map of a model [Papp 2022, §4, end]. A step draws a few views, on several cores if there are.
///
/// From each of evenly spread directions, with the eye beyond the bounding sphere, it draws the mesh at low resolution
/// (projection/view_raster.h). It drops a view that covers less than the square's area (the isoptic test). The distance
/// of each visible vertex from the nearest blocked texel is the radius of the disc that fits around it; √2 times that
/// is the edge of a square that fits at every rotation. One distance transform thus gives every inner offset of the
/// silhouette, and the union over the views is the greatest value. Greatest means size times the cosine between the
/// view and the mean normal around the vertex. Without the cosine, views of a cube from the side would reach around an
/// edge without gaining size, and would draw the best centre away from the middle of the face.
///
/// The map also excludes two cases that an exact test would allow but nobody wants: surface that the eye sees at more
/// than kMaxTiltDeg (pockets would be carved along it), and centres whose normal makes more than kMaxCentreTiltDeg with
/// the line of sight (a code around the corner of a cube).
///
/// The map is an estimate, not a proof: accurate to a texel or two (minMm / 16, or 1/512 of the model), and limited by
/// the detail that the simplified mesh keeps.
class SizeMapSearch {
 public:
  static constexpr double kMaxTiltDeg = 65;
  static constexpr double kMaxCentreTiltDeg = 35;

  /// @param normals  unit or zero, one per vertex of the mesh
  SizeMapSearch(const Mesh& mesh, std::span<const Vec3f> normals, const SizeMapOptions& options);
  ~SizeMapSearch();

  /// Adds the next views. @returns true when all are done
  bool step();

  double doneFraction() const;

  /// Returns the map; call it once, after the last step.
  SizeMap takeMap();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Runs all steps.
SizeMap makeSizeMap(const Mesh& mesh, std::span<const Vec3f> normals, const SizeMapOptions& options);

}  // namespace qrelief
