// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "math/frame.h"
#include "printing/layer_grid.h"
#include "printing/print_process.h"

namespace qrelief {

/// The layers of a print round a code, as far as an eye sees them: on a slope only a band of each. Everything in the
/// printer's space, whose third axis is up; the lowest corner of the model lies on the bed.
///
/// A layer has the outline that laid_outline.h makes of the model's cross-section at half its height, and round flanks,
/// so that a groove lies between two layers. Its plane is divided into square tiles, and made where something of it may
/// be seen.
class PrintedLayers {
 public:
  using Corners = std::array<Vec3, 3>;
  /// A triangle cut by a few planes, each of which adds a corner at most.
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

  /// Cost: O(triangles) and O(area seen / finest²); at most 40 million nodes, coarser ones where more would be needed.
  /// @param triangles  of a solid, anticlockwise seen from outside
  /// @param frame      of the code: the eye, and
  /// @param extentMm   the edge of the square of its QR plane that is looked through
  /// @param roughness  see PrintRequest
  PrintedLayers(std::vector<Corners> triangles, const ProjectionFrame& frame, double extentMm,
                const PrintProcess& process, double roughness);

  /// Distance from the eye at which the ray to a point of the QR plane meets plastic; 0: it meets nothing.
  /// @param fromMm  nearer to the eye there is none
  double firstMeeting(Vec2 at, double fromMm = 0) const;

 private:
  struct Ray;
  class RayInTile;
  static constexpr int kNoTile = -1;
  struct Layer {
    std::vector<int> numbers;  ///< of each tile, row-major: where it stands in `tiles`; empty: nothing of it is seen
    std::vector<LayerGrid> tiles;
  };

  struct TileRange {
    int firstColumn, lastColumn, firstRow, lastRow;
    int count() const { return (lastColumn - firstColumn + 1) * (lastRow - firstRow + 1); }
  };

  double topOf(int layer) const { return bedMm_ + (firstLayer_ + layer + 1) * process_.layerMm; }
  int layerAt(double z) const;
  double haloMm() const;
  void findTiles(double extentMm);
  void addToLayers(const Polygon& part, double marginMm);
  TileRange tilesRound(const Polygon& polygon, double marginMm) const;
  void addRange(Layer& layer, const TileRange& range) const;
  void addTiles(Layer& layer, const Polygon& within, double marginMm) const;
  void lay(double roughness);
  void layLayer(Layer& layer, std::span<const Segment2> outline, Vec2 corner, int winding, int steps) const;
  std::vector<std::vector<Segment2>> nearTiles(const Layer& layer, std::span<const Segment2> outline, Vec2 first,
                                               double beyond) const;
  const LayerGrid* tileAt(int layer, Vec2 at) const;
  double wayOutOfTile(const Ray& ray, Vec2 at) const;
  double meetingInLayer(int layer, const Ray& ray, double begin, double end) const;
  double refined(int layer, const Ray& ray, double outside, double inside) const;

  PrintProcess process_;
  ProjectionFrame frame_;
  std::vector<Corners> triangles_;
  double bedMm_ = 0, nearestMm_ = 0, farthestMm_ = 0;
  int firstLayer_ = 0;
  Vec2 origin_{0};  ///< of the tiles, which are the same in all layers
  double tileMm_ = 0;
  int tileColumns_ = 0, tileRows_ = 0;
  std::vector<Layer> layers_;
};

}  // namespace qrelief
