// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/ray_surface.h"
#include "printing/printed_surface.h"

namespace qrelief {

/// Four texels that are neighbours, and the two triangles between them.
struct TexelCell {
  double low, right, left, high;  ///< heights of the texels at (0, 0), (1, 0), (0, 1), (1, 1)
  bool risingDiagonal;            ///< from `low` to `high`; else from `right` to `left`
};

/// Rays on a printed surface, from the side that the eye is on: what is met there, without a tree over its triangles.
///
/// Seen from the eye the surface is a height map over the texels. Central projection with 1/depth for the height takes
/// lines to lines and triangles to triangles, so a ray is walked from texel to texel, as over a terrain [Musgrave
/// 1988], past blocks of which it is above everything.
class PrintedRays final : public RaySurface {
 public:
  /// Cost: O(texels).
  explicit PrintedRays(const PrintedSurface& surface);

  using RaySurface::firstHit;
  /// What a ray meets from below it passes through.
  /// Cost: O(texels passed near the surface), and an eighth as much of others.
  /// @param origin  in front of the eye, or the eye itself
  std::optional<SurfacePoint> firstHit(Vec3 origin, Vec3 direction, double from) const override;

  Vec3 normalAt(const SurfacePoint& at) const override;

 private:
  /// A ray in the map: column and row in texels, height; `s` runs along it.
  struct MapRay {
    Vec3 at{0}, step{0};
    double depth = 0, depthStep = 0;  // of the origin below the eye, and of the direction

    Vec3 point(double s) const { return at + step * s; }
    /// In units of the direction's length.
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
  std::vector<float> blockTops_;  // greatest of a block's texels and those that border on it
};

}  // namespace qrelief
