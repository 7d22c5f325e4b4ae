// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/ray.h"
#include "printing/printed_surface.h"

namespace qrelief::study {

/// Four neighbouring texels, and the two triangles between them.
struct TexelCell {
  double low, right, left, high;  ///< heights of the texels at (0, 0), (1, 0), (0, 1), (1, 1)
  bool risingDiagonal;            ///< true: from `low` to `high`; false: from `right` to `left`
};

/// Rays that hit a printed surface from the eye's side, traced without a tree over its triangles.
///
/// Seen from the eye the surface is a height map over the texels. Central projection with 1/depth as the height maps
/// lines to lines and triangles to triangles. So a ray is traced from texel to texel, as over a terrain [Musgrave
/// 1988], and skips blocks that lie wholly below it.
class PrintedRays final : public RaySurface {
 public:
  /// Cost: O(texels).
  explicit PrintedRays(const PrintedSurface& surface);

  using RaySurface::firstHit;
  /// Finds the first hit from above; a ray passes through the surface from below.
  /// Cost: O(texels passed near the surface), and an eighth as much for other texels.
  /// @param origin  in front of the eye, or the eye itself
  std::optional<SurfacePoint> firstHit(Vec3 origin, Vec3 direction, double from) const override;

  Vec3 normalAt(const SurfacePoint& at) const override;

 private:
  /// A ray in the map: column and row in texels, height; `s` runs along it.
  struct MapRay {
    Vec3 at{0}, step{0};
    double depth = 0, depthStep = 0;  // depth of the origin below the eye, and of the direction

    Vec3 point(double s) const { return at + step * s; }
    /// Converts a position on the map ray to a parameter in units of the direction's length.
    double parameter(double s) const { return s * depth / (1 - s * depthStep); }
    double place(double parameter) const { return parameter / (depth + parameter * depthStep); }
  };

  float heightAt(int column, int row) const {
    return heights_[static_cast<std::size_t>(row) * static_cast<std::size_t>(texels_) +
                    static_cast<std::size_t>(column)];
  }
  Vec3 position(int column, int row) const;
  std::optional<TexelCell> cellAt(int column, int row) const;
  std::optional<SurfacePoint> seenFromEye(Vec3 direction, double from) const;
  std::optional<SurfacePoint> walk(const MapRay& ray, double begin, double end, Vec3 origin, Vec3 direction) const;

  ProjectionFrame frame_;
  int texels_ = 0, blocks_ = 0;  // along the edge
  double texelMm_ = 0;
  std::vector<float> heights_;    // see PrintedSurface::height()
  std::vector<float> blockTops_;  // greatest height of a block's texels and of those that border on it
};

}  // namespace qrelief::study
