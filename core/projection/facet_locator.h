// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "projection/plane_grid.h"

namespace qrelief {

/// Which of some facets, projected on the QR plane, lies under a point?
class FacetLocator {
 public:
  /// @param images  counter-clockwise, inner points not overlapping; at least one
  explicit FacetLocator(std::vector<Triangle2> images);

  /// The facet that contains the point, on a common border the one it lies deepest in, ties by index; where none does,
  /// one that it misses by little more than rounding if there is such a one, else any.
  std::uint32_t nearest(Vec2 point);

  /// How far a point lies within a facet: its distance from the nearest side's line, negative outside.
  double depthIn(std::uint32_t facet, Vec2 point) const;

 private:
  std::vector<Triangle2> images_;
  PlaneGrid grid_;
};

}  // namespace qrelief
