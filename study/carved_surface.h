// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "depth/depth_field.h"
#include "mesh/ray_tree.h"
#include "study/spot.h"

namespace qrelief::study {

/// A spot carved to given depths, for methods that trace rays.
class CarvedSurface {
 public:
  /// @returns the error of embedDepthField() if that fails
  static Result<CarvedSurface> make(const StudyPlacement& spot, const DepthField& depths);

  const Mesh& mesh() const { return *mesh_; }
  const RayTree& tree() const { return *tree_; }

  /// Returns a point of a submodule as seen by the eye; none if the ray misses the model.
  /// @param submodule  row-major from the symbol's top left
  /// @param place      in [0, 1]², from the submodule's top left
  std::optional<SurfacePoint> pointOf(std::uint32_t submodule, Vec2 place) const;
  std::optional<SurfacePoint> middleOf(std::uint32_t submodule) const { return pointOf(submodule, {0.5, 0.5}); }

  /// Returns the distance at which a ray meets the model, mm; none if it meets nothing. @param direction  unit
  std::optional<double> distanceMm(const SurfacePoint& at, Vec3 direction) const {
    const auto hit = tree_->firstHit(at.position, direction, kOffMm);
    return hit ? std::optional(glm::length(hit->position - at.position)) : std::nullopt;
  }
  bool isOpen(const SurfacePoint& at, Vec3 direction) const { return !distanceMm(at, direction); }

  /// Returns the normal of the facet, towards the eye.
  Vec3 normalAt(const SurfacePoint& at) const;

 private:
  static constexpr double kOffMm = 1e-4;  // a ray starts beyond its own facet

  CarvedSurface() = default;
  std::unique_ptr<Mesh> mesh_;
  std::unique_ptr<RayTree> tree_;
  ProjectionFrame frame_;
  DepthField depths_;
};

/// The sky as seen from a point of the surface.
struct SkySeen {
  double cosineWeighted = 0;  ///< ∫ cos ω over the open directions, divided by π: 1 = all
  double solidAngle = 0;      ///< of the open directions, sr, 0 … 2π
};

/// Casts rays evenly over the hemisphere.
/// @param rays  ≥ 1; Halton points, turned at random by the seed
/// @param tell  called with the cosine of each ray and the distance of the hit, if any
void overHemisphere(const CarvedSurface& surface, const SurfacePoint& at, int rays, std::uint64_t seed,
                    const std::function<void(double, const std::optional<double>&)>& tell);

/// Measures the sky with these rays.
SkySeen skySeen(const CarvedSurface& surface, const SurfacePoint& at, int rays, std::uint64_t seed);

}  // namespace qrelief::study
