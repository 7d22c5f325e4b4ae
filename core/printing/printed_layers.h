// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
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
/// round flanks, so that a groove lies between two layers. Its plane is divided into square tiles. A tile is computed
/// when the first ray meets it: most of those that may be visible lie behind others.
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

  /// Cuts the solid into layers, and finds the tiles that may be visible.
  /// Cost: O(triangles), and with all rays O(visible area / finest²); at most 40 million nodes, with coarser steps
  /// where more might be needed.
  /// @param frame      of the code, with the eye
  /// @param extentMm   edge of the visible square of the QR plane
  /// @param roughness  see PrintRequest
  PrintedLayers(const Solid& solid, const ProjectionFrame& frame, double extentMm, const PrintProcess& process,
                double roughness);

  /// Returns the distance from the eye at which the ray to a point of the QR plane hits plastic; 0: no hit. Several
  /// threads may call it at the same time.
  /// @param fromMm  start of the search; there is no plastic nearer to the eye
  double firstHit(Vec2 at, double fromMm = 0) const;

 private:
  struct Ray;
  class RayInTile;
  static constexpr int kNoTile = -1;
  struct Tile {
    std::once_flag once;
    std::atomic<bool> isLaid{false};
    LayerGrid grid;  ///< empty until then
  };
  struct Layer {
    /// Per tile, row-major: its index in `tiles` and `outlines`, or kNoTile. Empty: the layer is invisible.
    std::vector<int> numbers;
    int count = 0;  ///< tiles that may be visible
    std::unique_ptr<Tile[]> tiles;
    std::vector<std::vector<Segment2>> outlines;  ///< the segments that touch each tile's window
    std::vector<std::int16_t> windings;           ///< per tile, row-major: the winding number at its window's corner
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
  void cut(const Solid& solid, double roughness);
  Vec2 firstWindow() const;
  std::vector<std::vector<Segment2>> nearTiles(const Layer& layer, std::span<const Segment2> outline) const;
  LayerGrid layTile(const Layer& layer, int tile) const;
  RayInTile tileAt(const Ray& ray, double t) const;
  const LayerGrid* gridOf(int layer, const RayInTile& tile) const;
  double hitInLayer(int layer, const Ray& ray, RayInTile& inTile, double begin, double end) const;
  double refined(int layer, const Ray& ray, double outside, double inside) const;

  PrintProcess process_;
  ProjectionFrame frame_;
  double bedMm_ = 0, nearestMm_ = 0, farthestMm_ = 0;
  int firstLayer_ = 0;
  Vec2 origin_{0};                 ///< lower left corner of the tiles, which are the same in all layers
  double tileMm_ = 0;              ///< edge of a tile
  int steps_ = 1, haloSteps_ = 0;  ///< of a tile's grid along its edge, and beyond it on each side
  double stepMm_ = 0, stepsPerMm_ = 0;
  int tileColumns_ = 0, tileRows_ = 0;
  std::vector<Layer> layers_;
};

}  // namespace qrelief
