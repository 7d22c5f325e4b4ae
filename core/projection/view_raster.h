// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "math/frame.h"
#include "mesh/topology.h"

namespace qrelief {

/// The square of the QR plane that a raster covers, centred on the frame.
struct RasterWindow {
  double extentMm = 0;  ///< edge of the square, > 0
  int texels = 0;       ///< along the edge, > 2; texel (0, 0) at the lower left

  double texelMm() const { return extentMm / texels; }
};

/// A view of a coarse mesh, in texels, that marks where a code cannot lie.
///
/// Drawn by the processor, not the GPU: a map takes hundreds of small views of about ten thousand facets, for which
/// waiting for the read-back costs more than drawing (bench/spot_search.cpp). The result is also the same on every
/// machine. A copy shares what is the same in every view, and may draw at the same time as the original.
class ViewRaster {
 public:
  /// @param mesh, adjacency  kept by reference
  ViewRaster(const Mesh& mesh, const Adjacency& adjacency);

  /// Draws the facets that face the eye, with their depths. Then blocks the texels that show no surface, that show too
  /// oblique a facet, or that a visible contour edge passes (an edge between a facet that faces the eye and one that
  /// does not, see projection/contour.h).
  ///
  /// A contour edge counts as visible unless all nine texels around it are nearer: next to a visible contour something
  /// is always farther.
  /// Cost: O(T + texels²).
  /// @param frame      all vertices lie in front of its eye
  /// @param minCosine  between a facet's normal and the direction to the eye
  void draw(const ProjectionFrame& frame, const RasterWindow& window, double minCosine);

  /// Returns values that are not 0 where no code can lie.
  std::span<const std::uint8_t> blocked() const { return blocked_; }
  /// Returns the area of the texels that show a surface.
  double coveredMm2() const { return covered_ * window_.texelMm() * window_.texelMm(); }
  /// Returns the position of a vertex in the last view, in texels; its integer part is the texel.
  Vec2 at(std::uint32_t vertex) const { return {vertices_[vertex].x, vertices_[vertex].y}; }
  /// Returns true if nothing in the last view is nearer than a vertex of the surface, given that no contour lies within
  /// two texels of it.
  bool sees(std::uint32_t vertex) const;

 private:
  struct Seen {
    float x = 0, y = 0;      // texels
    float inverseDepth = 0;  // 1 / distance along the axis
  };
  void project(const ProjectionFrame& frame);
  void drawFacets(const ProjectionFrame& frame, double minCosine);
  void drawFacet(const Triangle& triangle, bool oblique);
  void drawContours();
  void drawContour(const Seen& from, const Seen& to);
  float farthestAround(float x, float y) const;

  struct Normals {
    std::vector<Vec3> flat;    // of the facets
    std::vector<Vec3> smooth;  // of the facets, from their corners' normals: slope without the noise of single facets
  };
  static Normals normalsOf(const Mesh& mesh);

  const Mesh* mesh_;
  const Adjacency* adjacency_;
  std::shared_ptr<const Normals> normals_;
  RasterWindow window_;
  float depthSlack_ = 0;  // inverse depths closer than this belong to one sheet
  std::vector<Seen> vertices_;
  std::vector<std::uint8_t> front_;
  std::vector<float> inverseDepth_;  // 0 = no surface
  std::vector<std::uint8_t> blocked_;
  double covered_ = 0;
};

}  // namespace qrelief
