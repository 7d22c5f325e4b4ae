// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
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

  /// Returns the point at which a ray meets the model; none if it meets nothing. @param direction  unit
  std::optional<SurfacePoint> hitFrom(const SurfacePoint& at, Vec3 direction) const {
    return tree_->firstHit(at.position, direction, kOffMm);
  }

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

/// Directions spread evenly over the hemisphere above a surface: Halton points, shifted at random by a seed.
class Hemisphere {
 public:
  Hemisphere(Vec3 normal, std::uint64_t seed);

  /// Returns the cosine between a direction and the normal. @param i  of the direction, counted from 0
  double cosine(std::size_t i) const;
  Vec3 direction(std::size_t i) const;

 private:
  Vec3 normal_, right_, up_;
  Vec2 shift_;
};

}  // namespace qrelief::study
