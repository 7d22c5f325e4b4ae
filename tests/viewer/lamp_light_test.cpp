// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/lamp_light.h"

#include <algorithm>
#include <cmath>

#include "base/grid.h"
#include "math/angle.h"
#include "verification/mesh_luminance.h"
#include "viewer/viewer_fixture.h"

namespace qrelief {
namespace {

double linearOf(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

/// A viewer that looks from above on the plane z = 0.
class LampLightTest : public ViewerFixture {
 protected:
  void lookFromAbove(const Mesh& mesh, double extentMm) {
    show(mesh);
    camera_.lookThrough(frame_, extentMm);
    camera_.finishGlide();
  }
  void light(std::vector<DirectionalLight> lamps, double fineMm = 30) {
    LampLight light{{}, openIrradiance(lamps), albedo_, {}, fineMm};
    for (const DirectionalLight& lamp : lamps) light.lamps.push_back({towards(lamp), lamp.strength});
    viewer_->setLight(light);
  }
  /// Returns the luminance of the light at a place in the picture, 1 = an unoccluded surface in the plane.
  double luminance(const Picture& picture, Vec3 place) const {
    return linearOf(picture.at(camera_.toScreen(place)).y) / SurfaceColours{}.body.y;
  }

  ProjectionFrame frame_ = makeFrame({}, {0, 0, 1}, {0, 1, 0}, 250);
  double albedo_ = 0.7;
};

/// A wall along x = 0, `heightMm` high and 2 mm thick.
Mesh plateWithWall(double heightMm) {
  return shapes::plate({60, 60}, 4, 240, 4, [=](double x, double) { return std::abs(x) < 1 ? heightMm : 0.0; });
}

TEST_F(LampLightTest, TheShadowOfAWallFallsAwayFromTheLamp) {
  lookFromAbove(plateWithWall(5), 50);
  const Vec3 left(-4, 0, 0), right(4, 0, 0);
  light({{.azimuthDeg = 180, .elevationDeg = 40, .strength = 3}});
  const Picture fromLeft = refined();
  EXPECT_GT(luminance(fromLeft, left), 2 * luminance(fromLeft, right));
  light({{.azimuthDeg = 0, .elevationDeg = 40, .strength = 3}});
  const Picture fromRight = refined();
  EXPECT_GT(luminance(fromRight, right), 2 * luminance(fromRight, left));
  const double shadowMm = 5 / std::tan(toRadians(40.0));
  EXPECT_NEAR(luminance(fromRight, {-1 - shadowMm - 1, 10, 0}), 1, 0.15) << "beyond the shadow";
}

TEST_F(LampLightTest, TheLuminanceIsThatOfTheDepthSearch) {
  const Mesh mesh = plateWithWall(2);
  lookFromAbove(mesh, 24);
  const std::vector<DirectionalLight> lamps = {{.azimuthDeg = 180, .elevationDeg = 30, .strength = 2},
                                               {.azimuthDeg = 90, .elevationDeg = 60, .strength = 0.5}};
  light(lamps);
  const Picture picture = refined();
  const BottomUp<float> expected =
      meshLuminance(mesh, frame_, {.pixels = 240, .pixelMm = 0.1, .nearMm = 10, .albedo = albedo_, .lamps = lamps});
  double most = 0;
  for (const double x : {-10.0, -6.0, -3.0, -2.0, 0.0, 2.0, 3.0, 3.8, 6.0, 10.0}) {
    const Vec3 place(x, 1, x == 0 ? 2.0 : 0.0);
    const Vec2 onPlane = frame_.project(place) / 0.1 + Vec2(120);
    const double wanted = expected.at(static_cast<int>(onPlane.y), static_cast<int>(onPlane.x));
    EXPECT_NEAR(luminance(picture, place), wanted, 0.06) << x;
    most = std::max(most, std::abs(wanted - 1));
  }
  EXPECT_GT(most, 0.4) << "the shadow is among the places";
}

TEST_F(LampLightTest, ALampBelowTheHorizonLightsNothing) {
  lookFromAbove(shapes::box({40, 40, 20}), 30);
  viewer_->setLight(LampLight{{{Vec3(0.6, 0, -0.8), 5}}, 2, albedo_, {}, 30});
  EXPECT_NEAR(luminance(refined(), {0, 0, 10}), 0.5, 0.02) << "the sky alone";
}

TEST_F(LampLightTest, ShadowsOfSmallStepsNeedTheFineMap) {
  lookFromAbove(shapes::plate({120, 120}, 4, 960, 2,  // a groove along x = 0, 2 mm wide and 0.3 mm deep
                              [](double x, double) { return std::abs(x) < 1 ? -0.3 : 0.0; }),
                6);
  const Vec3 shaded(-0.7, 0, -0.3), lit(0.5, 0, -0.3);
  const DirectionalLight lamp{.azimuthDeg = 180, .elevationDeg = 25, .strength = 4};
  light({lamp}, 5);
  const Picture fine = refined();
  EXPECT_LT(luminance(fine, shaded), 0.5 * luminance(fine, lit));
  light({lamp}, 400);
  const Picture coarse = refined();
  EXPECT_GT(luminance(coarse, shaded), 0.8 * luminance(coarse, lit));
}

TEST_F(LampLightTest, AFrameInWhichOnlyALampMovedIsThatOfAFullRedraw) {
  const Mesh mesh = plateWithWall(5);
  const auto lampAt = [](double azimuthDeg) {
    return std::vector<DirectionalLight>{{.azimuthDeg = azimuthDeg, .elevationDeg = 40, .strength = 3},
                                         {.azimuthDeg = 90, .elevationDeg = 50, .strength = 1}};
  };
  const auto frame = [&] {
    draw(clock_ += 30);
    return Picture{target_.readRgba()};
  };
  lookFromAbove(mesh, 50);
  light(lampAt(0));
  const Picture before = frame();
  for (const double azimuthDeg : {40.0, 200.0}) {
    light(lampAt(azimuthDeg));
    const Picture lit = frame();
    lookFromAbove(mesh, 50);  // another model of the same shape: nothing is kept
    EXPECT_EQ(lit.rgba, frame().rgba) << azimuthDeg;
    EXPECT_NE(lit.rgba, before.rgba) << azimuthDeg;
  }
  refined();
  light(lampAt(0));
  EXPECT_EQ(frame().rgba, before.rgba) << "a frame after the picture came to rest";
}

TEST_F(LampLightTest, WhatIsCutAwayCastsNoShadow) {
  lookFromAbove(plateWithWall(5), 50);
  light({{.azimuthDeg = 180, .elevationDeg = 40, .strength = 3}});
  const Vec3 behind(4, 0, 0);
  const double shaded = luminance(refined(), behind);
  viewer_->setCut(CuttingPlane{{2, 0, 0}, {-1, 0, 0}});
  EXPECT_GT(luminance(refined(), behind), 2 * shaded);
  viewer_->setCut({});
  EXPECT_NEAR(luminance(refined(), behind), shaded, 0.02);
}

TEST_F(LampLightTest, OtherModelsCastOtherShadowsAndTheViewersOwnLightComesBack) {
  lookFromAbove(plateWithWall(5), 50);
  const Picture own = refined();
  light({{.azimuthDeg = 180, .elevationDeg = 40, .strength = 3}});
  EXPECT_LT(luminance(refined(), {4, 0, 0}), 0.6);
  lookFromAbove(plateWithWall(0), 50);
  EXPECT_NEAR(luminance(refined(), {4, 0, 0}), 1, 0.03);
  lookFromAbove(plateWithWall(5), 50);
  viewer_->setLight({});
  EXPECT_EQ(refined().rgba, own.rgba);
}

}  // namespace
}  // namespace qrelief
