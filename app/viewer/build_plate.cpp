// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/build_plate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "viewer/grid_plane.h"

namespace qrelief {
namespace {

constexpr double kFadeShare = 0.45;   // width of the margin in which the grid fades out, as a part of the footprint's
                                      // diagonal
constexpr double kLeastFadeMm = 15;   // so that a small model has a few lines around it
constexpr double kBelowShare = 1e-3;  // lowers the drawn plate, as a part of the footprint's diagonal, so that the face
                                      // on it does not show through
// Strengths of the plate between the eye and the model, which must stay visible.
constexpr float kLineBelow = 0.6f, kGroundBelow = 0.2f;
constexpr double kAxisCosine = 0.8;  // an axis nearer to the vertical than this does not give the plate its direction

// sRGB colours and their opacities.
constexpr Vec3f kDarkLine{0.62f, 0.70f, 0.82f}, kLightLine{0.22f, 0.28f, 0.38f};
constexpr Vec3f kDarkGround{0.62f, 0.70f, 0.82f}, kLightGround{1.0f, 1.0f, 1.0f};
constexpr float kDarkLineOpacity = 0.34f, kLightLineOpacity = 0.34f;
constexpr float kDarkGroundOpacity = 0.05f, kLightGroundOpacity = 0.30f;

/// Returns the model's axis that lies nearest to the plate, X before Y.
Vec3 axisAcross(Vec3 up) { return std::abs(up.x) < kAxisCosine ? Vec3(1, 0, 0) : Vec3(0, 1, 0); }

}  // namespace

BuildPlate plateUnder(const Mesh& mesh, Vec3 up) {
  BuildPlate plate;
  plate.up = glm::normalize(up);
  plate.back = glm::normalize(glm::cross(plate.up, axisAcross(plate.up)));
  plate.right = glm::cross(plate.back, plate.up);
  Vec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vec3f& position : mesh.positions) {
    const Vec3 at(position);
    const Vec3 along(glm::dot(at, plate.right), glm::dot(at, plate.back), glm::dot(at, plate.up));
    low = glm::min(low, along);
    high = glm::max(high, along);
  }
  if (mesh.positions.empty()) return plate;
  const Vec3 middle = (low + high) / 2.0;
  plate.centre = plate.right * middle.x + plate.back * middle.y + plate.up * low.z;
  plate.halfMm = Vec2(high - low) / 2.0;
  plate.heightMm = high.z - low.z;
  return plate;
}

void drawPlate(const gl::Program& program, const BuildPlate& plate, const CameraView& camera, bool dark) {
  const double diagonalMm = 2 * glm::length(plate.halfMm);
  const double fadeMm = std::max(kLeastFadeMm, kFadeShare * diagonalMm);
  const Vec3 lowered = plate.centre - plate.up * (kBelowShare * diagonalMm);
  const bool isBelow = glm::dot(camera.eye() - lowered, plate.up) < 0;
  const float line = (dark ? kDarkLineOpacity : kLightLineOpacity) * (isBelow ? kLineBelow : 1);
  const float ground = (dark ? kDarkGroundOpacity : kLightGroundOpacity) * (isBelow ? kGroundBelow : 1);
  drawGridPlane(program,
                {lowered,
                 plate.right,
                 plate.back,
                 plate.halfMm,
                 fadeMm,
                 {dark ? kDarkLine : kLightLine, line},
                 {dark ? kDarkGround : kLightGround, ground}},
                camera);
}

}  // namespace qrelief
