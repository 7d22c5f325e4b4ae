// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/collinear.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <cmath>

namespace qrelief {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Bound of the rounding error of two differences, two products and their difference, relative to the products.
constexpr double kRounding = 1e-15;

/// Returns true if a·b - c·d is certainly not zero. Products of floats cannot underflow in doubles.
bool certainlyNonzero(double a, double b, double c, double d) {
  const double first = a * b;
  const double second = c * d;
  return std::abs(first - second) > kRounding * (std::abs(first) + std::abs(second));
}

}  // namespace

bool collinear(Vec3f a, Vec3f b, Vec3f c) {
  const Vec3 u = Vec3(b) - Vec3(a);
  const Vec3 v = Vec3(c) - Vec3(a);
  if (certainlyNonzero(u.x, v.y, u.y, v.x) || certainlyNonzero(u.y, v.z, u.z, v.y) ||
      certainlyNonzero(u.z, v.x, u.x, v.z))
    return false;
  const auto point = [](Vec3f p) { return Kernel::Point_3(p.x, p.y, p.z); };
  return CGAL::collinear(point(a), point(b), point(c));
}

}  // namespace qrelief
