// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "math/box.h"
#include "mesh/bvh.h"

namespace qrelief {

/// Bounding volume hierarchy that finds the distance of the nearest facet within a reach. Its nodes also store the
/// range of their facets' normals.
///
/// Cost: O(n log n) to build; a query that finds nothing within reach usually visits only a few boxes.
class FacetTree {
 public:
  using Facet = std::array<Vec3, 3>;

  /// @param facets  finite; may be empty or without area
  explicit FacetTree(std::span<const Facet> facets);

  /// The nearest facet that a query has found. The next query measures it first, which makes it fast near the last
  /// one's point; the answer does not depend on it.
  struct Hint {
    std::uint32_t facet = 0;
  };

  /// Returns the distance of the nearest facet from `point`, or `reach` if none is nearer.
  double distance(Vec3 point, double reach, Hint& hint) const;

  /// Returns the same among facets whose unit normal has a component below `component` along the unit vector `normal`.
  /// Because nodes know the range of their normals, smooth surfaces that nowhere turn so far cost next to nothing.
  double distanceOfTurned(Vec3 point, double reach, Vec3 normal, double component, Hint& hint) const;

 private:
  template <class NodeCounts, class FacetCounts>
  double nearest(Vec3 point, double reach, Hint& hint, const NodeCounts& nodeCounts,
                 const FacetCounts& facetCounts) const;

  Bvh tree_;
  std::vector<Facet> facets_;  // in the tree's order
  std::vector<Box3> normals_;  // of the facets below each node
};

}  // namespace qrelief
