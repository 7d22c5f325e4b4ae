// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/box.h"

namespace qrelief {

/// Answers how near the nearest of a set of facets is, as long as it is near: a tree of boxes over the facets, halved
/// along the longest side of their middles' box.
///
/// Cost: O(n log n) to build; a query whose answer is "none within reach" usually looks at a few boxes only.
class FacetTree {
 public:
  using Facet = std::array<Vec3, 3>;

  /// @param facets  finite; may be empty or without area
  explicit FacetTree(std::vector<Facet> facets);

  /// Distance of the nearest facet from `point`, or `reach` if none is nearer.
  double distance(Vec3 point, double reach) const;

  /// The same among those facets alone whose unit normal has a component below `component` along the unit vector
  /// `normal`. As nodes know the range of their normals, smooth surfaces that turn nowhere so far cost next to nothing.
  double distanceOfTurned(Vec3 point, double reach, Vec3 normal, double component) const;

 private:
  struct Node {
    Box3 box, normals;
    std::uint32_t begin = 0, end = 0;  // facets; inner nodes have none
    std::uint32_t right = 0;           // second child; the first follows its parent
  };

  template <class NodeCounts, class FacetCounts>
  double nearest(Vec3 point, double reach, const NodeCounts& nodeCounts, const FacetCounts& facetCounts) const;
  std::uint32_t build(std::uint32_t begin, std::uint32_t end);

  std::vector<Facet> facets_;
  std::vector<Node> nodes_;
};

}  // namespace qrelief
