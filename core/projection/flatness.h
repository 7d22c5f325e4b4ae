// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <span>

#include "mesh/mesh.h"
#include "render/surface_renderer.h"

namespace qrelief {

/// Least-squares plane through weighted heights.
class PlaneFit {
 public:
  void add(Vec2 at, double height, double weight = 1);
  PlaneFit& operator+=(const PlaneFit& other);
  PlaneFit& operator-=(const PlaneFit& part);
  double weight() const { return weights_; }
  /// Returns the root mean square distance of the heights from the plane; 0 if the heights determine no plane.
  double rms() const;

 private:
  glm::dmat3 moments_{0};  // moments of (1, u, v)
  Vec3 products_{0};       // products with the height
  double squares_ = 0, weights_ = 0;
};

/// Returns how much the surface under a code bends, mm: the root mean square deviation of its heights over the QR plane
/// from the plane that fits them best. Seen from the side, bending shifts the modules against each other.
/// @param surface  SurfaceMaps::surface of the window, texels² values; texels off the model are ignored
/// @returns 0 if fewer than three texels show the model
double bendMm(std::span<const float> surface, const MapWindow& window);

/// Returns the same for some facets of a mesh, as the frame's eye sees them within a square of the QR plane about the
/// centre.
double bendMm(const Mesh& mesh, std::span<const std::uint32_t> triangles, const ProjectionFrame& frame, double edgeMm);

/// Returns the largest angle off the eye's axis at which a code on such a surface decodes from every side, degrees, at
/// most `kMaxAimDeg`. A decoder assumes a flat code, and tolerates modules that are displaced by a quarter of their
/// width on average. Fitted to codes in ink on 42 spots of 11 models (`script/bench aside`): right to within 2° on 41
/// of them, as far as the tested tilts show; far too high on one next to a model's edge. A carved code does no better,
/// because its pockets hide their floors from the side.
/// @param moduleMm  > 0
double aimToleranceDeg(double bendMm, double moduleMm);
inline constexpr double kMaxAimDeg = 45;

/// Tilt within which people hold a phone without taking care. A code that decodes at this tilt needs no careful
/// aiming.
inline constexpr double kForgivingTiltDeg = 10;

}  // namespace qrelief
