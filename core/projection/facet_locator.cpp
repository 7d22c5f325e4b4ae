// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/facet_locator.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace qrelief {

FacetLocator::FacetLocator(std::vector<Triangle2> images)
    : images_(std::move(images)), grid_(images_, std::numeric_limits<double>::infinity()) {
  assert(!images_.empty());
}

double FacetLocator::depthIn(std::uint32_t facet, Vec2 point) const {
  const Triangle2& image = images_[facet];
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 side = image[(k + 1) % 3] - image[k];
    depth = std::min(depth, cross2(side, point - image[k]) / glm::length(side));
  }
  return depth;
}

std::uint32_t FacetLocator::nearest(Vec2 point) {
  std::uint32_t best = 0;
  double bestDepth = -std::numeric_limits<double>::infinity();
  for (const std::uint32_t facet : grid_.near({point, point, point})) {
    const double depth = depthIn(facet, point);
    if (depth < bestDepth || (depth == bestDepth && facet > best)) continue;
    best = facet;
    bestDepth = depth;
  }
  return best;
}

}  // namespace qrelief
