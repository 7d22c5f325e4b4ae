// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/view_raster.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "math/triangle_bands.h"

namespace qrelief {
namespace {

constexpr float kContourStep = 0.5f;  // texels between two samples along a contour edge

}  // namespace

ViewRaster::Normals ViewRaster::normalsOf(const Mesh& mesh) {
  Normals normals;
  normals.flat.reserve(mesh.triangles.size());
  normals.smooth.reserve(mesh.triangles.size());
  const std::vector<Vec3f> smooth = vertexNormals(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    normals.flat.push_back(triangleNormal(mesh, t));
    const Triangle& corners = mesh.triangles[t];
    const Vec3 sum = Vec3(smooth[corners[0]]) + Vec3(smooth[corners[1]]) + Vec3(smooth[corners[2]]);
    normals.smooth.push_back(glm::length(sum) > 0 ? glm::normalize(sum) : sum);
  }
  return normals;
}

ViewRaster::ViewRaster(const Mesh& mesh, const Adjacency& adjacency)
    : mesh_(&mesh),
      adjacency_(&adjacency),
      normals_(std::make_shared<const Normals>(normalsOf(mesh))),
      vertices_(mesh.positions.size()),
      front_(mesh.triangles.size()) {}

void ViewRaster::draw(const ProjectionFrame& frame, const RasterWindow& window, double minCosine) {
  assert(window.texels > 2 && window.extentMm > 0);
  window_ = window;
  const auto texels = static_cast<std::size_t>(window.texels) * static_cast<std::size_t>(window.texels);
  inverseDepth_.assign(texels, 0.0f);
  blocked_.assign(texels, 0);
  project(frame);
  // A surface at 45° to the line of sight recedes by one texel's width per texel.
  depthSlack_ = static_cast<float>(window.texelMm() / (frame.eyeDistance * frame.eyeDistance));
  drawFacets(frame, minCosine);
  std::size_t covered = 0;
  for (std::size_t i = 0; i < texels; ++i) {
    if (inverseDepth_[i] > 0)
      ++covered;
    else
      blocked_[i] = 1;
  }
  covered_ = static_cast<double>(covered);
  drawContours();
}

void ViewRaster::project(const ProjectionFrame& frame) {
  const double perMm = 1 / window_.texelMm();
  const double middle = window_.texels / 2.0;
  const Vec3 eye = frame.eye();
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    const Vec3 fromEye = Vec3(mesh_->positions[v]) - eye;
    const double depth = -glm::dot(fromEye, frame.normal);
    const double scale = frame.eyeDistance / depth * perMm;
    vertices_[v] = {static_cast<float>(scale * glm::dot(fromEye, frame.right) + middle),
                    static_cast<float>(scale * glm::dot(fromEye, frame.up) + middle), static_cast<float>(1 / depth)};
  }
}

void ViewRaster::drawFacets(const ProjectionFrame& frame, double minCosine) {
  const Vec3 eye = frame.eye();
  for (std::size_t t = 0; t < mesh_->triangles.size(); ++t) {
    const Vec3 toEye = eye - mesh_->corner(t, 0);
    front_[t] = glm::dot(normals_->flat[t], toEye) > 0 ? 1 : 0;
    if (front_[t] == 0) continue;
    drawFacet(mesh_->triangles[t], glm::dot(normals_->smooth[t], toEye) < minCosine * glm::length(toEye));
  }
}

void ViewRaster::drawFacet(const Triangle& triangle, bool oblique) {
  const Seen& a = vertices_[triangle[0]];
  const Seen& b = vertices_[triangle[1]];
  const Seen& c = vertices_[triangle[2]];
  const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (!(area > 0)) return;
  const TriangleTexels<float> drawn(a, b, c, window_.texels);
  const auto [bottom, top] = drawn.rows();
  for (int row = bottom; row <= top; ++row) {
    const float y = static_cast<float>(row) + 0.5f;
    const auto [left, right] = drawn.columns(row);
    for (int column = left; column <= right; ++column) {
      const float x = static_cast<float>(column) + 0.5f;
      const float ofA = (c.x - b.x) * (y - b.y) - (c.y - b.y) * (x - b.x);
      const float ofB = (a.x - c.x) * (y - c.y) - (a.y - c.y) * (x - c.x);
      const float ofC = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
      if (ofA < 0 || ofB < 0 || ofC < 0) continue;
      const float nearness = (ofA * a.inverseDepth + ofB * b.inverseDepth + ofC * c.inverseDepth) / area;
      const auto i = static_cast<std::size_t>(row * window_.texels + column);
      if (nearness <= inverseDepth_[i]) continue;
      inverseDepth_[i] = nearness;
      blocked_[i] = oblique ? 1 : 0;
    }
  }
}

float ViewRaster::farthestAround(float x, float y) const {
  const int column = std::clamp(static_cast<int>(x), 1, window_.texels - 2);
  const int row = std::clamp(static_cast<int>(y), 1, window_.texels - 2);
  const float* middle = inverseDepth_.data() + row * window_.texels + column;
  float least = *middle;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) least = std::min(least, middle[dy * window_.texels + dx]);
  return least;
}

bool ViewRaster::sees(std::uint32_t vertex) const {
  const Seen& v = vertices_[vertex];
  return v.inverseDepth >= farthestAround(v.x, v.y) - depthSlack_;
}

void ViewRaster::drawContours() {
  for (std::size_t t = 0; t < mesh_->triangles.size(); ++t) {
    if (front_[t] == 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t across = (*adjacency_)[t][k];
      if (across != kNoTriangle && front_[across] != 0) continue;
      const Triangle& triangle = mesh_->triangles[t];
      drawContour(vertices_[triangle[k]], vertices_[triangle[(k + 1) % 3]]);
    }
  }
}

void ViewRaster::drawContour(const Seen& from, const Seen& to) {
  const float dx = to.x - from.x;
  const float dy = to.y - from.y;
  const int steps = 1 + static_cast<int>(std::max(std::abs(dx), std::abs(dy)) / kContourStep);
  for (int i = 0; i <= steps; ++i) {
    const float fraction = static_cast<float>(i) / static_cast<float>(steps);
    const float x = from.x + dx * fraction;
    const float y = from.y + dy * fraction;
    const float nearness = from.inverseDepth + (to.inverseDepth - from.inverseDepth) * fraction;
    if (nearness < farthestAround(x, y) - depthSlack_) continue;
    const int column = std::clamp(static_cast<int>(x), 0, window_.texels - 1);
    const int row = std::clamp(static_cast<int>(y), 0, window_.texels - 1);
    blocked_[row * window_.texels + column] = 1;
  }
}

}  // namespace qrelief
