// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
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

/// What an eye sees of a coarse mesh, in texels: where a code cannot lie.
///
/// Drawn by the processor, not the GPU: a map takes hundreds of small views of some ten thousand facets, for which
/// waiting for the read-back costs more than drawing (bench/spot_search.cpp), and it is the same everywhere.
class ViewRaster {
 public:
  /// @param mesh, adjacency  kept by reference
  ViewRaster(const Mesh& mesh, const Adjacency& adjacency);

  /// Draws a view: facets that face the eye with their depths; then blocks the texels that show no surface, those whose
  /// facet is too oblique, and those that a contour edge passes which is seen (an edge between a facet that faces the
  /// eye and one that does not, see projection/contour.h).
  ///
  /// A contour edge counts as seen unless everything in the nine texels around it is nearer: beside a seen contour
  /// there is always something farther.
  /// Cost: O(T + texels²).
  /// @param frame        all vertices are farther than the eye's own plane
  /// @param minCosine  between a facet's normal and the direction to the eye
  void draw(const ProjectionFrame& frame, const RasterWindow& window, double minCosine);

  /// Not 0 where no code can lie.
  std::span<const std::uint8_t> blocked() const { return blocked_; }
  /// Of the texels that show a surface.
  double coveredMm2() const { return covered_ * window_.texelMm() * window_.texelMm(); }
  /// Position of a vertex in the last view, in texels; its integer part is the texel.
  Vec2 at(std::uint32_t vertex) const { return {vertices_[vertex].x, vertices_[vertex].y}; }
  /// Whether nothing in the last view is nearer than a vertex of the surface, given that no contour lies within two
  /// texels of it.
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

  const Mesh* mesh_;
  const Adjacency* adjacency_;
  std::vector<Vec3> normals_;        // of the facets
  std::vector<Vec3> smoothNormals_;  // of the facets, from their corners': slope without the noise of single facets
  RasterWindow window_;
  float depthSlack_ = 0;  // inverse depths that differ by less belong to one sheet
  std::vector<Seen> vertices_;
  std::vector<std::uint8_t> front_;
  std::vector<float> inverseDepth_;  // 0 = no surface
  std::vector<std::uint8_t> blocked_;
  double covered_ = 0;
};

}  // namespace qrelief
