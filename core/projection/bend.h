// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <span>

#include "mesh/mesh.h"
#include "render/geometry_pass.h"

namespace qrelief {

/// Least squares plane through weighted heights over places.
class PlaneFit {
 public:
  void add(Vec2 at, double height, double weight = 1);
  /// Root mean square of what the heights are off the plane; 0 if no plane is determined.
  double rms() const;

 private:
  glm::dmat3 moments_{0};  // of (1, u, v)
  Vec3 products_{0};       // with the height
  double squares_ = 0, weights_ = 0;
};

/// How far a surface departs from a plane under a code: root mean square of its heights over the QR plane, mm, about
/// the plane that fits them best. It moves the modules against each other when the code is seen from aside.
/// @param surface  SurfaceMaps::surface of the window, texels² of it; what is no model does not count
/// @returns 0 if there are not three texels of the model
double bendMm(std::span<const float> surface, const MapWindow& window);

/// The same of some of a mesh's facets, as a frame's eye sees them over a square of the QR plane about the centre.
double bendMm(const Mesh& mesh, std::span<const std::uint32_t> triangles, const ProjectionFrame& frame, double edgeMm);

/// From how far aside of the eye that it is projected for, to every side, a code on such a surface can be read,
/// degrees, at most `kMaxAimDeg`: as a reader takes the code for flat, it puts up with modules that are moved by a
/// quarter of their width on average. Fitted to codes in ink on 42 spots of 11 models (`script/bench aside`): right to
/// within 2° on 41, as far as the tilts tried tell; far too high on one beside a model's edge. A carving, whose pockets
/// hide their floors from aside, reads no farther.
/// @param moduleMm  > 0
double aimToleranceDeg(double bendMm, double moduleMm);
inline constexpr double kMaxAimDeg = 45;

/// Hands hold a phone as straight as this without taking care: what is read from as far aside forgives aiming.
inline constexpr double kForgivingTiltDeg = 10;

}  // namespace qrelief
