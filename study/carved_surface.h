// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "carving/depth_field.h"
#include "mesh/ray_tree.h"
#include "study/spot.h"

namespace qrelief::study {

/// A spot carved to some depths, for rays: what the methods that trace them ask.
class CarvedSurface {
 public:
  /// @returns what embedDepthField() returns where it fails
  static Result<CarvedSurface> make(const Spot& spot, const DepthField& depths);

  const Mesh& mesh() const { return *mesh_; }
  const RayTree& tree() const { return *tree_; }

  /// A point of a submodule as the eye sees it; nothing where the model is missed.
  /// @param submodule  row-major from the symbol's top left
  /// @param place      in [0, 1]², from the submodule's top left
  std::optional<SurfacePoint> pointOf(std::uint32_t submodule, Vec2 place) const;
  std::optional<SurfacePoint> middleOf(std::uint32_t submodule) const { return pointOf(submodule, {0.5, 0.5}); }

  /// How far a ray goes until it meets the model, mm; nothing if it leaves it. @param direction  unit
  std::optional<double> distanceMm(const SurfacePoint& at, Vec3 direction) const {
    const auto hit = tree_->firstHit(at.position, direction, kOffMm);
    return hit ? std::optional(glm::length(hit->position - at.position)) : std::nullopt;
  }
  bool isOpen(const SurfacePoint& at, Vec3 direction) const { return !distanceMm(at, direction); }

  /// Normal of the facet, towards the eye.
  Vec3 normalAt(const SurfacePoint& at) const;

 private:
  static constexpr double kOffMm = 1e-4;  // a ray starts beyond its own facet

  CarvedSurface() = default;
  std::unique_ptr<Mesh> mesh_;
  std::unique_ptr<RayTree> tree_;
  ProjectionFrame frame_;
  DepthField depths_;
};

/// What a point of the surface sees of the sky.
struct SkySeen {
  double cosineWeighted = 0;  ///< ∫ cos ω over what is open, divided by π: 1 = all
  double solidAngle = 0;      ///< of what is open, sr, 0 … 2π
};

/// Asks rays evenly spread over the hemisphere for what they meet.
/// @param rays  ≥ 1; Halton points, turned at random by the seed
/// @param tell  called with the cosine of each ray and the distance of what it meets
void overHemisphere(const CarvedSurface& surface, const SurfacePoint& at, int rays, std::uint64_t seed,
                    const std::function<void(double, const std::optional<double>&)>& tell);

/// By such rays.
SkySeen skySeen(const CarvedSurface& surface, const SurfacePoint& at, int rays, std::uint64_t seed);

}  // namespace qrelief::study
