// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/orientation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace qrelief::detail {

int exactSideOfPlane(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto point = [](Vec3 p) { return Kernel::Point_3(p.x, p.y, p.z); };
  return static_cast<int>(CGAL::orientation(point(a), point(b), point(c), point(d)));
}

}  // namespace qrelief::detail
