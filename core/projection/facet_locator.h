// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "projection/plane_grid.h"

namespace qrelief {

/// Finds the facet under a point among facets projected onto the QR plane.
class FacetLocator {
 public:
  /// @param images  counter-clockwise, interiors not overlapping; at least one
  explicit FacetLocator(std::vector<Triangle2> images);

  /// Returns the facet that contains the point: on a common border the one in which it lies deepest, ties by index. If
  /// none contains it, returns one that it misses by little more than rounding if possible, else any.
  std::uint32_t nearest(Vec2 point);

  /// Returns how deep a point lies within a facet: its distance from the nearest side's line, negative outside.
  double depthIn(std::uint32_t facet, Vec2 point) const;

 private:
  std::vector<Triangle2> images_;
  PlaneGrid grid_;
};

}  // namespace qrelief
