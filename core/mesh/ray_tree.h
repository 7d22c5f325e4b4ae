// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "mesh/bvh.h"
#include "mesh/mesh.h"
#include "mesh/ray.h"

namespace qrelief {

/// For many rays: a bounding volume hierarchy and the watertight triangle test [Woop, Benthin, Wald 2013].
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
  const Mesh* mesh_;
  Bvh tree_;
};

}  // namespace qrelief
