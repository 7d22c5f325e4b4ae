// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/ray.h"
#include "mesh/wide_bvh.h"

namespace qrelief {

/// A surface for many rays: a bounding volume hierarchy and the watertight triangle test [Woop, Benthin, Wald 2013].
class RayTree final : public RaySurface {
 public:
  /// Cost: O(T log T).
  /// @param mesh  kept by reference
  explicit RayTree(const Mesh& mesh);

  using RaySurface::firstHit;
  /// Hits triangles from either side. Cost: usually O(log T).
  std::optional<SurfacePoint> firstHit(Vec3 origin, Vec3 direction, double from) const override;

  Vec3 normalAt(const SurfacePoint& at) const override { return triangleNormal(*mesh_, at.triangle); }

  const Mesh& mesh() const { return *mesh_; }

 private:
  RayTree(const Mesh& mesh, const Bvh& tree);

  const Mesh* mesh_;
  std::vector<std::uint32_t> order_;  // of the triangles, leaf after leaf
  WideBvh tree_;
};

}  // namespace qrelief
