// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "math/vec.h"

namespace qrelief {

/// The QR plane and the central projection it defines [Papp 2022, §3, fig. 1]:
///
///           E  eye = centre + eyeDistance·normal
///          /|\          plane coordinates (u, v) mm: u along `right`, v along `up`,
///         / | \         origin at `centre`
///     ---u--C--+---  QR plane
///       /   |   \       every plane point ↔ one ray from E
///    ~~~~~~ surface ~~~~~~
///
/// right, up, normal are orthonormal, right × up = normal.
struct ProjectionFrame {
  Vec3 centre{0};
  Vec3 right{1, 0, 0};
  Vec3 up{0, 1, 0};
  Vec3 normal{0, 0, 1};      ///< towards the viewer
  double eyeDistance = 250;  ///< mm

  bool operator==(const ProjectionFrame&) const = default;

  Vec3 eye() const { return centre + normal * eyeDistance; }

  /// Returns the point in space of a point of the QR plane.
  Vec3 onPlane(Vec2 p) const { return centre + right * p.x + up * p.y; }

  /// Returns the unit direction from the eye through a plane point.
  Vec3 rayDirection(Vec2 p) const { return glm::normalize(right * p.x + up * p.y - normal * eyeDistance); }

  /// Returns the distance from the eye along -normal, mm; positive in front of the viewer.
  double distanceAlongAxis(Vec3 q) const { return glm::dot(eye() - q, normal); }

  /// Projects a point centrally; it must lie in front of the eye (distanceAlongAxis > 0).
  Vec2 project(Vec3 q) const {
    const Vec3 fromEye = q - eye();
    const double k = eyeDistance / -glm::dot(fromEye, normal);
    return {k * glm::dot(fromEye, right), k * glm::dot(fromEye, up)};
  }
};

/// Makes a frame at `centre` that looks along -normal, with `up` as near to `upHint` as possible.
/// @param normal  any length > 0
/// @param upHint  any vector; if it is nearly parallel to the normal, +Y and then +X takes its place
ProjectionFrame makeFrame(Vec3 centre, Vec3 normal, Vec3 upHint, double eyeDistance);

/// Returns the frame turned about its normal, anticlockwise as the viewer sees it.
ProjectionFrame turned(const ProjectionFrame& frame, double radians);

}  // namespace qrelief
