// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "math/frame.h"
#include "mesh/mesh.h"
#include "printing/layer_grid.h"
#include "printing/print_process.h"

namespace qrelief {

/// The layers of a print around a code, as far as an eye sees them: on a slope only a band of each. Everything is in
/// the printer's space, whose third axis is up; the lowest corner of the model lies on the bed.
///
/// A layer has the outline that extruded_outline.h computes from the model's cross-section at half its height, and
/// round flanks, so that a groove lies between two layers. Its plane is divided into square tiles; only tiles that may
/// be visible are computed.
class PrintedLayers {
 public:
  using Corners = std::array<Vec3, 3>;
  /// A triangle clipped by a few planes; each plane adds at most one corner.
  class Polygon {
   public:
    Polygon() = default;
    explicit Polygon(const Corners& triangle) : size_(3) {
      std::copy(triangle.begin(), triangle.end(), corners_.begin());
    }

    void add(Vec3 corner) { corners_[size_++] = corner; }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    const Vec3& operator[](std::size_t i) const { return corners_[i]; }
    const Vec3& front() const { return corners_[0]; }
    const Vec3* begin() const { return corners_.data(); }
    const Vec3* end() const { return corners_.data() + size_; }

   private:
    static constexpr std::size_t kMostPlanes = 8;
    std::array<Vec3, 3 + kMostPlanes> corners_{};
    std::size_t size_ = 0;
  };

  /// A solid in the printer's space, its triangles anticlockwise seen from outside.
  struct Solid {
    std::span<const Vec3> positions;
    std::span<const Triangle> triangles;

    Corners corners(std::size_t triangle) const {
      const Triangle& t = triangles[triangle];
      return {positions[t[0]], positions[t[1]], positions[t[2]]};
    }
  };

  /// Computes the visible tiles of all layers.
  /// Cost: O(triangles) and O(visible area / finest²); at most 40 million nodes, with coarser steps where more would be
  /// needed.
  /// @param frame      of the code, with the eye
  /// @param extentMm   edge of the visible square of the QR plane
  /// @param roughness  see PrintRequest
  PrintedLayers(const Solid& solid, const ProjectionFrame& frame, double extentMm, const PrintProcess& process,
                double roughness);

  /// Returns the distance from the eye at which the ray to a point of the QR plane hits plastic; 0: no hit.
  /// @param fromMm  start of the search; there is no plastic nearer to the eye
  double firstHit(Vec2 at, double fromMm = 0) const;

 private:
  struct Ray;
  class RayInTile;
  static constexpr int kNoTile = -1;
  struct Layer {
    std::vector<int> numbers;  ///< per tile, row-major: its index in `tiles`; empty: the layer is invisible
    std::vector<LayerGrid> tiles;
  };

  struct TileRange {
    int firstColumn, lastColumn, firstRow, lastRow;
    int count() const { return (lastColumn - firstColumn + 1) * (lastRow - firstRow + 1); }
  };

  double topOf(int layer) const { return bedMm_ + (firstLayer_ + layer + 1) * process_.layerMm; }
  int layerAt(double z) const;
  double haloMm() const;
  void findTiles(const Solid& solid, double extentMm);
  void addToLayers(const Polygon& part, double marginMm);
  TileRange tilesRound(const Polygon& polygon, double marginMm) const;
  void addRange(Layer& layer, const TileRange& range) const;
  void addTiles(Layer& layer, const Polygon& within, double marginMm) const;
  std::vector<Corners> trianglesWithin(const Solid& solid, Vec2 low, Vec2 high) const;
  void extrude(const Solid& solid, double roughness);
  void layLayer(Layer& layer, std::span<const Segment2> outline, Vec2 corner, int winding, int steps) const;
  std::vector<std::vector<Segment2>> nearTiles(const Layer& layer, std::span<const Segment2> outline, Vec2 first,
                                               double beyond) const;
  RayInTile tileAt(const Ray& ray, double t) const;
  const LayerGrid* gridOf(int layer, const RayInTile& tile) const;
  double hitInLayer(int layer, const Ray& ray, RayInTile& inTile, double begin, double end) const;
  double refined(int layer, const Ray& ray, double outside, double inside) const;

  PrintProcess process_;
  ProjectionFrame frame_;
  double bedMm_ = 0, nearestMm_ = 0, farthestMm_ = 0;
  int firstLayer_ = 0;
  Vec2 origin_{0};                      ///< lower left corner of the tiles, which are the same in all layers
  double tileMm_ = 0, stepsPerMm_ = 0;  ///< edge of a tile; steps of its grid in a mm
  int tileColumns_ = 0, tileRows_ = 0;
  std::vector<Layer> layers_;
};

}  // namespace qrelief
