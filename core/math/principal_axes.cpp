// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/principal_axes.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace qrelief {
namespace {

using Matrix = std::array<Vec3, 3>;  // columns

Matrix covariance(std::span<const Vec3> points) {
  const double count = static_cast<double>(points.size());
  Vec3 mean(0);
  for (const Vec3 p : points) mean += p / count;
  Matrix sum{Vec3(0), Vec3(0), Vec3(0)};
  for (const Vec3 p : points)
    for (std::size_t k = 0; k < 3; ++k) sum[k] += (p - mean) * (p - mean)[static_cast<int>(k)];
  return sum;
}

/// Turns the axes p and q of a symmetric matrix so that its element (p, q) vanishes; turns `axes` with it.
void rotate(Matrix& m, Matrix& axes, int p, int q) {
  const auto first = static_cast<std::size_t>(p);
  const auto second = static_cast<std::size_t>(q);
  if (m[second][p] == 0) return;
  const double cotangent = (m[second][q] - m[first][p]) / (2 * m[second][p]);  // of twice the angle
  const double t = std::copysign(1.0, cotangent) / (std::abs(cotangent) + std::sqrt(1 + cotangent * cotangent));
  const double c = 1 / std::sqrt(1 + t * t);
  const double s = t * c;
  const auto mix = [c, s](double& a, double& b) {
    const double before = a;
    a = c * before - s * b;
    b = s * before + c * b;
  };
  for (int row = 0; row < 3; ++row) mix(m[first][row], m[second][row]);
  for (Vec3& column : m) mix(column[p], column[q]);
  for (int row = 0; row < 3; ++row) mix(axes[first][row], axes[second][row]);
}

}  // namespace

Vec3 leastVarianceAxis(std::span<const Vec3> points) {
  if (points.size() < 3) return Vec3(0);
  Matrix m = covariance(points);
  Matrix axes{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  // Convergence is quadratic; six sweeps settle every 3 × 3 matrix.
  for (int sweep = 0; sweep < 6; ++sweep) {
    rotate(m, axes, 0, 1);
    rotate(m, axes, 0, 2);
    rotate(m, axes, 1, 2);
  }
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (m[k][static_cast<int>(k)] < m[least][static_cast<int>(least)]) least = k;
  return glm::normalize(axes[least]);
}

}  // namespace qrelief
