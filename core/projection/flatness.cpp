// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/flatness.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <unordered_map>

#include "math/angle.h"
#include "render/surface_raster.h"

namespace qrelief {
namespace {

constexpr int kTexels = 64;
constexpr double kMovedModules = 0.24;  // root mean square displacement that a decoder tolerates

}  // namespace

void PlaneFit::add(Vec2 at, double height, double weight) {
  const Vec3 terms(1, at.x, at.y);
  moments_ += weight * glm::outerProduct(terms, terms);
  products_ += weight * height * terms;
  squares_ += weight * height * height;
  weights_ += weight;
}

PlaneFit& PlaneFit::operator+=(const PlaneFit& other) {
  moments_ += other.moments_;
  products_ += other.products_;
  squares_ += other.squares_;
  weights_ += other.weights_;
  return *this;
}

PlaneFit& PlaneFit::operator-=(const PlaneFit& part) {
  moments_ -= part.moments_;
  products_ -= part.products_;
  squares_ -= part.squares_;
  weights_ -= part.weights_;
  return *this;
}

double PlaneFit::rms() const {
  // Lengths have any unit, so compare the determinant with that of the same spread in all directions.
  const double spread = moments_[1][1] + moments_[2][2];
  if (!(glm::determinant(moments_) > 1e-9 * weights_ * spread * spread)) return 0;
  const Vec3 plane = glm::inverse(moments_) * products_;
  return std::sqrt(std::max(0.0, squares_ - glm::dot(plane, products_)) / weights_);
}

double bendMm(std::span<const float> surface, const MapWindow& window) {
  PlaneFit fit;
  for (int row = 0; row < window.texels; ++row) {
    for (int column = 0; column < window.texels; ++column) {
      const float* texel = &surface[4 * static_cast<std::size_t>(row * window.texels + column)];
      if (texel[2] > 0) fit.add(window.planePoint(column, row), static_cast<double>(texel[3]));
    }
  }
  return fit.rms();
}

double bendMm(const Mesh& mesh, std::span<const std::uint32_t> triangles, const ProjectionFrame& frame, double edgeMm) {
  Mesh part;
  std::unordered_map<std::uint32_t, std::uint32_t> vertexOf;
  for (const std::uint32_t t : triangles) {
    Triangle corners = mesh.triangles[t];
    for (std::uint32_t& vertex : corners) {
      const auto [known, isNew] = vertexOf.try_emplace(vertex, static_cast<std::uint32_t>(part.positions.size()));
      if (isNew) part.positions.push_back(mesh.positions[vertex]);
      vertex = known->second;
    }
    part.triangles.push_back(corners);
  }
  const MapWindow window{edgeMm, kTexels};
  return bendMm(SurfaceRaster(part).draw(frame, window), window);
}

double aimToleranceDeg(double bendMm, double moduleMm) {
  return std::min(kMaxAimDeg, toDegrees(std::atan2(kMovedModules * moduleMm, bendMm)));
}

}  // namespace qrelief
