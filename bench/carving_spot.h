// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "depth/depth_field.h"
#include "depth/wall_limit.h"
#include "math/tolerance.h"
#include "mesh/prepare.h"
#include "mesh/ray.h"
#include "message_codes/pipeline.h"
#include "projection/silhouette.h"
#include "projection/size.h"
#include "qr/module_pattern.h"

namespace qrelief::bench {

/// A place for a code, found without a GPU: the eye looks along the mean normal of the surface around the centre.
struct Spot {
  ProjectionFrame frame;
  VisiblePatch patch;
  double symbolMm = 0;  ///< the largest that fits with its quiet zone at any rotation, 35 at most
};

inline Result<Spot> findSpot(const PreparedModel& model, Vec3 centreMm, int modules) {
  constexpr double kLargestMm = 35;
  const double outer = (modules + 8.0) / modules;
  const auto surface = closestPoint(model.mesh, centreMm);
  if (!surface) return badInput(message<"no-surface">());
  Vec3 normal = triangleNormal(model.mesh, surface->triangle);
  Spot best;
  for (int round = 0; round < 2; ++round) {
    const ProjectionFrame frame = makeFrame(surface->position, normal, {0, 0, 1}, 250);
    auto patch = findSilhouette(model.mesh, model.adjacency, frame, surface->triangle, kLargestMm * outer);
    if (!patch) return best.symbolMm > 0 ? Result<Spot>(best) : tl::unexpected(patch.error());
    const double size = std::min(kLargestMm, freeSize(patch->silhouette) / outer);
    normal = Vec3(0);
    for (const std::uint32_t t : patch->triangles) {
      const Vec3 a = model.mesh.corner(t, 0), b = model.mesh.corner(t, 1), c = model.mesh.corner(t, 2);
      if (glm::distance((a + b + c) / 3.0, surface->position) < size / 2) normal += glm::cross(b - a, c - a);
    }
    if (size > best.symbolMm) best = {frame, std::move(*patch), size};
    if (glm::length(normal) == 0) break;
  }
  return best;
}

/// Carves every submodule of the mask to a depth, or less where the walls behind it limit it.
inline DepthField carveEvenly(const PreparedModel& model, const Spot& spot, const SubmoduleMask& mask, double depthMm) {
  DepthField field{mask.rows(), spot.symbolMm, {}};
  for (const double limit :
       wallLimits(model.mesh, spot.patch, spot.frame, mask, {spot.symbolMm, depthMm, /*minWallMm=*/0.8}))
    field.depthMm.push_back(std::floor(limit / kDepthQuantumMm) * kDepthQuantumMm);
  return field;
}

}  // namespace qrelief::bench
