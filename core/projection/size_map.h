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
  double minMm = 10;  ///< edge of the square looked for, > 0: how fine the map must be, and which views are dropped
  int views = 240;    ///< directions looked from, ≥ 1
  std::optional<Vec3> onlyFrom{};  ///< the only direction looked from, any length > 0; none: all around
  std::size_t facets = 24000;      ///< a mesh with more is drawn by a coarser one of about so many, ≥ 100
};

/// Where on a model squares fit, and how large.
struct SizeMap {
  Mesh mesh;                   ///< the model, coarser and with its long edges cut
  std::vector<Vec3f> normals;  ///< one for each of its vertices
  /// Edge of the largest square about each vertex that fits at every rotation, as some view sees it, mm; 0 if none
  /// does.
  std::vector<float> sizeMm;
  std::vector<Vec3f> direction;  ///< unit, towards the eye that saw it; zero where none did
  bool isCoarser = false;        ///< than the model; else the model's vertices come first, unchanged
  /// Vertex of the map's mesh that each vertex of the model became.
  std::vector<std::uint32_t> vertexOf;
  int viewsDropped = 0;  ///< as their silhouette is smaller than the square
};

/// Unit vectors spread evenly over the sphere: a spherical Fibonacci lattice [Swinbank, Purser 2006].
/// @param index  0 … count - 1
Vec3 latticeDirection(int index, int count);

/// The size map of a model [Papp 2022, §4, end], one view a step.
///
/// From each of evenly spread directions, with the eye beyond the bounding sphere, the mesh is drawn small
/// (projection/view_raster.h); a view that covers less than the square's area is dropped (the isoptic test). The
/// distance of each seen vertex from the nearest blocked texel is the radius of the disc that fits around it; √2 times
/// that is the edge of a square that fits at every rotation. So every inner offset of the silhouette is had at once,
/// and the union over the views is the greatest value. Greatest is size times the cosine at which the surface around
/// the centre is seen: on a cube, views from the side reach around an edge without gaining size, and would draw the
/// best centre away from the middle of the face.
///
/// Beyond the silhouette two things are kept out that an exact test would allow, but nobody wants: surface that the eye
/// sees at more than kMaxTiltDeg (pockets would be carved along it), and centres that lie at more than
/// kMaxCentreTiltDeg to the line of sight (a code around the corner of a cube).
///
/// It is a map, not a proof: right to a texel or two (minMm / 32, or 1/512 of the model) and to what the coarser mesh
/// keeps of the model's detail.
class SizeMapSearch {
 public:
  static constexpr double kMaxTiltDeg = 65;
  static constexpr double kMaxCentreTiltDeg = 35;

  /// @param normals  unit or zero, one per vertex of the mesh
  SizeMapSearch(const Mesh& mesh, std::span<const Vec3f> normals, const SizeMapOptions& options);
  ~SizeMapSearch();

  /// One view. @returns true when all are done
  bool step();

  double doneFraction() const;
  const SizeMap& map() const;

  /// The map, once, after the last step.
  SizeMap takeMap();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// All steps at once.
SizeMap makeSizeMap(const Mesh& mesh, std::span<const Vec3f> normals, const SizeMapOptions& options);

}  // namespace qrelief
