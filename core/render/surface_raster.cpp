// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surface_raster.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/triangle_bands.h"

namespace qrelief {
namespace {

constexpr double kNearFraction = 1e-3;  // of the eye's distance: parts nearer to the eye's plane are cut off

/// A corner in the frame's axes: right, up, and its distance from the eye along the axis.
struct Corner {
  double x = 0, y = 0, depth = 0;
};

/// A corner in texels, with the inverse depth, which is linear there.
struct Seen {
  double x = 0, y = 0;
  double inverseDepth = 0;
};

/// The map being drawn, with the inverse depths of the visible surface.
class Canvas {
 public:
  Canvas(const ProjectionFrame& frame, const MapWindow& window)
      : eyeDistance_(frame.eyeDistance),
        perMm_(frame.eyeDistance / window.texelMm()),
        middle_(window.texels / 2.0),
        texels_(window.texels),
        map_(4 * static_cast<std::size_t>(texels_) * static_cast<std::size_t>(texels_)),
        inverseDepths_(map_.size() / 4) {}

  /// @param normal  of the facet, in the frame's axes, any length
  void draw(const std::array<Corner, 3>& facet, Vec3 normal) {
    const Vec3 unit = glm::normalize(normal);
    const double nearest = kNearFraction * eyeDistance_;
    const bool isWhole = std::all_of(facet.begin(), facet.end(), [&](const Corner& c) { return c.depth >= nearest; });
    if (isWhole) return drawSeen(seen(facet[0]), seen(facet[1]), seen(facet[2]), unit);
    std::vector<Seen> polygon;
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner &from = facet[k], &to = facet[(k + 1) % 3];
      if (from.depth >= nearest) polygon.push_back(seen(from));
      if ((from.depth >= nearest) == (to.depth >= nearest)) continue;
      const double t = (nearest - from.depth) / (to.depth - from.depth);
      polygon.push_back(seen({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y), nearest}));
    }
    for (std::size_t k = 2; k < polygon.size(); ++k) drawSeen(polygon[0], polygon[k - 1], polygon[k], unit);
  }

  std::vector<float> takeMap() { return std::move(map_); }

 private:
  Seen seen(const Corner& c) const {
    const double scale = perMm_ / c.depth;
    return {c.x * scale + middle_, c.y * scale + middle_, 1 / c.depth};
  }

  void drawSeen(const Seen& a, const Seen& b, const Seen& c, Vec3 normal) {
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (!(area > 0)) return;
    const TriangleTexels<double> drawn(a, b, c, texels_);
    const auto [bottom, top] = drawn.rows();
    for (int row = bottom; row <= top; ++row) {
      const double y = row + 0.5;
      const auto [left, right] = drawn.columns(row);
      for (int column = left; column <= right; ++column) {
        const double x = column + 0.5;
        const double ofA = (c.x - b.x) * (y - b.y) - (c.y - b.y) * (x - b.x);
        const double ofB = (a.x - c.x) * (y - c.y) - (a.y - c.y) * (x - c.x);
        const double ofC = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
        if (ofA < 0 || ofB < 0 || ofC < 0) continue;
        const double inverse = (ofA * a.inverseDepth + ofB * b.inverseDepth + ofC * c.inverseDepth) / area;
        const auto i =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(texels_) + static_cast<std::size_t>(column);
        if (inverse <= inverseDepths_[i]) continue;
        inverseDepths_[i] = inverse;
        for (int k = 0; k < 3; ++k) map_[4 * i + static_cast<std::size_t>(k)] = static_cast<float>(normal[k]);
        map_[4 * i + 3] = static_cast<float>(eyeDistance_ - 1 / inverse);
      }
    }
  }

  double eyeDistance_, perMm_, middle_;
  int texels_;
  std::vector<float> map_;
  std::vector<double> inverseDepths_;  // 0: no surface
};

}  // namespace

SurfaceRaster::SurfaceRaster(const Mesh& mesh)
    : SurfaceRaster(mesh, std::make_shared<const ClusteredTriangles>(clusterTriangles(mesh))) {}

SurfaceRaster::SurfaceRaster(const Mesh& mesh, std::shared_ptr<const ClusteredTriangles> clusters)
    : mesh_(&mesh), clustered_(std::move(clusters)) {}

/// Draws the facets that face the eye, or those seen from behind, with their corners reversed.
template <class Canvas>
void SurfaceRaster::drawFacets(Canvas& canvas, const ProjectionFrame& frame, const MapWindow& window,
                               bool front) const {
  const ViewPyramid pyramid(frame, window.extentMm);
  const Vec3 eye = frame.eye();
  for (const TriangleCluster& cluster : clustered_->clusters) {
    if (!pyramid.mayMeet(cluster.box) || (front ? cluster.facesAwayFrom(eye) : cluster.faces(eye))) continue;
    for (std::uint32_t t = cluster.begin; t < cluster.end; ++t) {
      std::array<Vec3, 3> fromEye;
      for (std::size_t k = 0; k < 3; ++k) fromEye[k] = Vec3(mesh_->positions[clustered_->triangles[t][k]]) - eye;
      if (!front) std::swap(fromEye[1], fromEye[2]);
      const Vec3 normal = glm::cross(fromEye[1] - fromEye[0], fromEye[2] - fromEye[0]);
      if (!(glm::dot(normal, fromEye[0]) < 0)) continue;  // faces away
      std::array<Corner, 3> facet;
      for (std::size_t k = 0; k < 3; ++k)
        facet[k] = {glm::dot(fromEye[k], frame.right), glm::dot(fromEye[k], frame.up),
                    -glm::dot(fromEye[k], frame.normal)};
      canvas.draw(facet, {glm::dot(normal, frame.right), glm::dot(normal, frame.up), glm::dot(normal, frame.normal)});
    }
  }
}

std::vector<float> SurfaceRaster::draw(const ProjectionFrame& frame, const MapWindow& window) const {
  Canvas canvas(frame, window);
  drawFacets(canvas, frame, window, true);
  return canvas.takeMap();
}

std::vector<float> SurfaceRaster::drawBack(const ProjectionFrame& frame, const MapWindow& window) const {
  Canvas canvas(frame, window);
  drawFacets(canvas, frame, window, false);
  return rayDistances(canvas.takeMap(), frame, window);
}

}  // namespace qrelief
