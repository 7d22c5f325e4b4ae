// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/common.hpp>
#include <limits>

#include "math/vec.h"

namespace qrelief {

/// Axis-aligned box; empty (min > max) until a point is added.
struct Box3 {
  Vec3 min{std::numeric_limits<double>::infinity()};
  Vec3 max{-std::numeric_limits<double>::infinity()};

  void add(Vec3 p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  bool empty() const { return min.x > max.x; }
  Vec3 size() const { return empty() ? Vec3(0) : max - min; }
  Vec3 centre() const { return (min + max) * 0.5; }
  double diagonal() const { return glm::length(size()); }
};

}  // namespace qrelief
