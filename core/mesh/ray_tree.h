// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/ray.h"

namespace qrelief {

/// A bounding volume hierarchy for many rays: split where the surface area heuristic says [Goldsmith, Salmon 1987;
/// binned, Wald 2007], watertight triangle test [Woop, Benthin, Wald 2013].
class RayTree {
 public:
  /// Cost: O(T log T).
  /// @param mesh  kept by reference
  explicit RayTree(const Mesh& mesh);

  /// First triangle met, from either side, farther than `from` along the ray. Cost: O(log T) as a rule.
  /// @param direction  any length > 0
  /// @param from       in units of the direction's length, ≥ 0: what lies nearer is passed over
  std::optional<SurfacePoint> firstHit(Vec3 origin, Vec3 direction, double from = 0) const;

  const Mesh& mesh() const { return *mesh_; }

 private:
  struct Node {
    Vec3f min, max;
    std::uint32_t
        begin;  ///< leaf: first of its triangles in order_; else the second child (the first is the next node)
    std::uint32_t count;  ///< triangles of a leaf; 0 = inner node
  };

  std::uint32_t build(std::uint32_t begin, std::uint32_t end, int level, const std::vector<Vec3f>& twiceCentres,
                      const std::vector<Node>& boxes);

  const Mesh* mesh_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace qrelief
