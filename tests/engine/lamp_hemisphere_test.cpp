// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/lamp_hemisphere.h"

#include <cmath>
#include <gtest/gtest.h>

namespace qrelief {
namespace {

const LampHemisphere kHemisphere{makeFrame({5, -3, 8}, {0.3, 0.5, 1}, {0, 1, 0}, 250), 20};

/// Returns the ray from a place of the frame, in radii, to a place.
Ray rayFrom(Vec3 inFrame, Vec3 to) {
  const ProjectionFrame& frame = kHemisphere.frame;
  const Vec3 from =
      frame.centre + kHemisphere.radiusMm * (inFrame.x * frame.right + inFrame.y * frame.up + inFrame.z * frame.normal);
  return {from, glm::normalize(to - from)};
}

TEST(LampHemisphere, ARayToALampLeavesItThere) {
  for (const double azimuthDeg : {0.0, 50.0, 90.0, 180.0, 271.0, 359.0}) {
    for (const double elevationDeg : {1.0, 20.0, 45.0, 88.0}) {
      const DirectionalLight lamp{azimuthDeg, elevationDeg, 3};
      for (const Vec3 eye : {Vec3(0, 0, 9), Vec3(8, 1, 3), Vec3(-2, -9, 1)})
        EXPECT_EQ(kHemisphere.moved(lamp, rayFrom(eye, kHemisphere.place(lamp))), lamp)
            << azimuthDeg << " " << elevationDeg;
    }
  }
}

TEST(LampHemisphere, ALampGoesToTheNearestPlaceOfTheRay) {
  const DirectionalLight before{0, 30, 2};
  const DirectionalLight wanted{20, 40, 2};
  EXPECT_EQ(kHemisphere.moved(before, rayFrom({9, 1, 2}, kHemisphere.place(wanted))), wanted);
  const DirectionalLight behind{185, 30, 2};  // the same ray meets the sphere twice
  const DirectionalLight moved = kHemisphere.moved(behind, rayFrom({9, 1, 2}, kHemisphere.place(wanted)));
  EXPECT_GT(std::abs(moved.azimuthDeg - wanted.azimuthDeg), 60);
}

TEST(LampHemisphere, ALampStaysOverTheQrPlane) {
  const ProjectionFrame& frame = kHemisphere.frame;
  const DirectionalLight lamp{0, 30, 2};
  const Vec3 beside = frame.centre + frame.up * 60.0;
  EXPECT_EQ(kHemisphere.moved(lamp, rayFrom({0, 0, 9}, beside)), (DirectionalLight{90, 18, 2}))
      << "misses the sphere, whose contour is at the arc sine of 1/√10";
  const DirectionalLight below = kHemisphere.moved(lamp, rayFrom({9, 0, 0}, frame.centre - frame.normal * 4.0));
  EXPECT_EQ(below.elevationDeg, 1);
  EXPECT_EQ(below.strength, 2);
}

TEST(LampHemisphere, ALampOverheadKeepsItsAzimuth) {
  const DirectionalLight lamp{123, 60, 1};
  EXPECT_EQ(kHemisphere.moved(lamp, rayFrom({0, 0, 9}, kHemisphere.frame.centre)), (DirectionalLight{123, 90, 1}));
}

}  // namespace
}  // namespace qrelief
