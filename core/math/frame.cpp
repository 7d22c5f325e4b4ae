// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/frame.h"

#include <array>
#include <cmath>

#include "math/tolerance.h"

namespace qrelief {

ProjectionFrame makeFrame(Vec3 centre, Vec3 normal, Vec3 upHint, double eyeDistance) {
  ProjectionFrame frame;
  frame.centre = centre;
  frame.normal = glm::normalize(normal);
  frame.eyeDistance = eyeDistance;
  for (const Vec3 hint : {upHint, Vec3(0, 1, 0), Vec3(1, 0, 0)}) {
    const double length = glm::length(hint);
    if (length == 0) continue;
    const Vec3 inPlane = hint / length - frame.normal * glm::dot(hint / length, frame.normal);
    if (glm::length(inPlane) < kParallelSine) continue;
    frame.up = glm::normalize(inPlane);
    break;
  }
  frame.right = glm::cross(frame.up, frame.normal);
  return frame;
}

ProjectionFrame turned(const ProjectionFrame& frame, double radians) {
  ProjectionFrame result = frame;
  result.right = frame.right * std::cos(radians) + frame.up * std::sin(radians);
  result.up = frame.up * std::cos(radians) - frame.right * std::sin(radians);
  return result;
}

}  // namespace qrelief
