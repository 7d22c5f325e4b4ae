// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/upright.h"

#include <algorithm>

namespace qrelief {
namespace {

constexpr double kPlaneFraction = 1e-3;  // of the height: scans and exports do not keep a plane exactly
constexpr double kLeastBase = 0.2;       // of the box's side
constexpr double kMostRest = 0.005;      // of the box's side; even a thin edge to stand on is more

/// Returns the area of the triangles in the lowest plane along an axis, as a fraction of that side of the box.
double baseFraction(const Mesh& mesh, const Box3& box, int axis) {
  const Vec3 size = box.size();
  const double top = box.min[axis] + kPlaneFraction * size[axis];
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
    if (std::max({a[axis], b[axis], c[axis]}) > top) continue;
    area -= ((b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u])) / 2;  // positive where it faces down
  }
  const double side = size[u] * size[v];
  return side > 0 ? area / side : 0;
}

}  // namespace

bool standsOnY(const Mesh& mesh) {
  const Box3 box = boundingBox(mesh);
  return baseFraction(mesh, box, 1) >= kLeastBase && baseFraction(mesh, box, 2) < kMostRest;
}

}  // namespace qrelief
