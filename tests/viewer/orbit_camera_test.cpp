// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/orbit_camera.h"

#include <cmath>
#include <gtest/gtest.h>

namespace qrelief {
namespace {

constexpr double kWidth = 900, kHeight = 700;

OrbitCamera cameraOver(Vec3 size) {
  OrbitCamera camera;
  camera.setViewport(kWidth, kHeight);
  Box3 box;
  box.add(-size / 2.0);
  box.add(size / 2.0);
  camera.setScene(box);
  camera.fitFromDefaultSide();
  return camera;
}

void expectNear(Vec3 a, Vec3 b, double tolerance) { EXPECT_LT(glm::length(a - b), tolerance); }

TEST(OrbitCamera, TheAxesAreOrthonormalAndRightHanded) {
  OrbitCamera camera = cameraOver({100, 60, 40});
  for (int i = 0; i < 20; ++i) {
    camera.orbit(37, 23);
    const CameraView view = camera.view();
    expectNear(glm::cross(view.right, view.up), view.back, 1e-12);
    EXPECT_NEAR(glm::length(view.back), 1, 1e-12);
  }
}

TEST(OrbitCamera, FittingShowsTheWholeBoxWithLittleMargin) {
  for (const Vec3 size : {Vec3(100, 100, 100), Vec3(5, 5, 200), Vec3(300, 20, 1)}) {
    const OrbitCamera camera = cameraOver(size);
    double outermost = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
      const Vec2 pixel = camera.toScreen(sign * size);
      outermost = std::max({outermost, std::abs(2 * pixel.x / kWidth - 1), std::abs(2 * pixel.y / kHeight - 1)});
    }
    EXPECT_LE(outermost, 1.0);
    EXPECT_GT(outermost, 0.85);
  }
}

TEST(OrbitCamera, TheRayThroughThePixelOfAPointHitsThePoint) {
  const OrbitCamera camera = cameraOver({80, 80, 80});
  const Vec3 point(12, -25, 31);
  const Vec2 pixel = camera.toScreen(point);
  const Ray ray = camera.ray(pixel.x, pixel.y);
  expectNear(glm::cross(glm::normalize(point - ray.origin), ray.direction), Vec3(0), 1e-12);
}

TEST(OrbitCamera, TheChosenAxisPointsUpOnTheScreen) {
  OrbitCamera camera = cameraOver({80, 80, 80});
  EXPECT_GT(camera.view().up.z, 0.9);
  camera.setUpAxis(UpAxis::Y);
  EXPECT_GT(camera.view().up.y, 0.9);
  expectNear(camera.skyward(), {0, 1, 0}, 1e-15);
  expectNear(glm::cross(camera.view().right, camera.view().up), camera.view().back, 1e-12);
}

TEST(OrbitCamera, AnotherDirectionComesUprightByAGlide) {
  for (const Vec3 up : {Vec3(1, 0, 0), Vec3(0, 0, -1), glm::normalize(Vec3(1, -2, 0.5))}) {
    OrbitCamera camera = cameraOver({100, 60, 40});
    const CameraView before = camera.view();
    camera.standOn(up);
    expectNear(camera.view().up, before.up, 1e-12);
    expectNear(camera.view().back, before.back, 1e-12);
    camera.finishGlide();
    const CameraView after = camera.view();
    EXPECT_NEAR(glm::dot(after.right, up), 0, 1e-12) << "no roll";
    EXPECT_GT(glm::dot(after.up, up), 0) << "upright";
    EXPECT_GT(glm::dot(after.back, up), 0.3) << "from above";
    expectNear(glm::cross(after.right, after.up), after.back, 1e-12);
    expectNear(camera.modelUp(), {0, 0, 1}, 1e-15);
    camera.orbit(30, 0);
    EXPECT_NEAR(glm::dot(camera.view().right, up), 0, 1e-12);
  }
}

TEST(OrbitCamera, OrbitingStopsAtThePolesAndNeverTurnsOver) {
  OrbitCamera camera = cameraOver({80, 80, 80});
  camera.orbit(0, 1e5);
  expectNear(camera.view().back, {0, 0, 1}, 1e-9);
  camera.orbit(0, -1e6);
  expectNear(camera.view().back, {0, 0, -1}, 1e-9);
}

TEST(OrbitCamera, DraggingDownRaisesTheCameraAndDraggingRightTurnsTheModelRight) {
  OrbitCamera camera = cameraOver({80, 80, 80});
  const Vec3 front = camera.view().back * 40.0;  // the model's point facing the eye
  const Vec2 before = camera.toScreen(front);
  camera.orbit(30, 0);
  EXPECT_GT(camera.toScreen(front).x, before.x);
  camera.orbit(-30, 30);
  EXPECT_GT(camera.toScreen(front).y, before.y);
}

TEST(OrbitCamera, PanningMovesTheTargetPlaneWithThePointer) {
  OrbitCamera camera = cameraOver({80, 80, 80});
  const Vec3 held = camera.onTargetPlane(300, 200);
  camera.pan(40, -25);
  const Vec2 pixel = camera.toScreen(held);
  EXPECT_NEAR(pixel.x, 340, 1e-6);
  EXPECT_NEAR(pixel.y, 175, 1e-6);
}

TEST(OrbitCamera, ZoomingKeepsTheFocusUnderThePointer) {
  OrbitCamera camera = cameraOver({80, 80, 80});
  const Vec3 focus(10, -30, 25);
  const Vec2 before = camera.toScreen(focus);
  camera.zoom(2.5, focus);
  const Vec2 after = camera.toScreen(focus);
  EXPECT_NEAR(after.x, before.x, 1e-6);
  EXPECT_NEAR(after.y, before.y, 1e-6);
}

TEST(OrbitCamera, ZoomingIsBoundedBothWays) {
  OrbitCamera camera = cameraOver({80, 80, 80});
  const double diagonal = std::sqrt(3.0) * 80;
  for (int i = 0; i < 200; ++i) camera.zoom(2, Vec3(0));
  EXPECT_NEAR(camera.pose().distance, 0.004 * diagonal, 1e-9);
  for (int i = 0; i < 200; ++i) camera.zoom(0.5, Vec3(0));
  EXPECT_NEAR(camera.pose().distance, 12 * diagonal, 1e-9);
  camera.zoom(std::nan(""), Vec3(0));
  camera.zoom(0, Vec3(0));
  EXPECT_NEAR(camera.pose().distance, 12 * diagonal, 1e-9);
}

TEST(OrbitCamera, TheReadersViewIsFromTheEyeWithTheCodeUpright) {
  for (const Vec3 normal : {Vec3(0.3, -0.8, 0.2), Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(-1, 0, 0)}) {
    OrbitCamera camera = cameraOver({80, 80, 80});
    camera.orbit(111, 57);
    const ProjectionFrame frame = makeFrame({3, 4, 5}, normal, {0.4, 0.5, 0.1}, 250);
    camera.lookThrough(frame, 40);
    EXPECT_TRUE(camera.advance(0));
    EXPECT_FALSE(camera.advance(1000));
    expectNear(camera.view().eye(), frame.eye(), 1e-9);
    expectNear(camera.view().up, frame.up, 1e-9);
    expectNear(camera.view().right, frame.right, 1e-9);
    const Vec2 top = camera.toScreen(frame.onPlane({0, 20}));
    EXPECT_NEAR(top.x, kWidth / 2, 1e-6);
    EXPECT_NEAR(top.y, 0, 1e-6);  // the square of 40 mm fills the height
  }
}

TEST(OrbitCamera, AGlideIsMonotoneAndEndsAtItsTarget) {
  OrbitCamera camera = cameraOver({80, 80, 80});
  const CameraPose home = camera.pose();
  camera.zoom(6, Vec3(20, 0, 0));
  camera.fit();
  double last = camera.pose().distance;
  EXPECT_TRUE(camera.advance(5000));
  for (double t = 5030; camera.advance(t); t += 30) {
    EXPECT_GE(camera.pose().distance, last);
    last = camera.pose().distance;
  }
  EXPECT_NEAR(camera.pose().distance, home.distance, 1e-9);
  expectNear(camera.pose().target, home.target, 1e-9);
}

TEST(OrbitCamera, DraggingInterruptsAGlide) {
  OrbitCamera camera = cameraOver({80, 80, 80});
  camera.zoom(6, Vec3(20, 0, 0));
  camera.fit();
  camera.advance(0);
  camera.advance(100);
  camera.pan(1, 0);
  EXPECT_FALSE(camera.advance(1000));
}

TEST(OrbitCamera, StandardViewsLookAlongTheAxesOfTheScene) {
  struct Expected {
    StandardView side;
    Vec3 back, up;
  };
  for (const auto& [side, back, up] :
       {Expected{StandardView::Front, {0, -1, 0}, {0, 0, 1}}, Expected{StandardView::Back, {0, 1, 0}, {0, 0, 1}},
        Expected{StandardView::Left, {-1, 0, 0}, {0, 0, 1}}, Expected{StandardView::Right, {1, 0, 0}, {0, 0, 1}},
        Expected{StandardView::Top, {0, 0, 1}, {0, 1, 0}}, Expected{StandardView::Bottom, {0, 0, -1}, {0, -1, 0}}}) {
    OrbitCamera camera = cameraOver({100, 60, 40});
    camera.orbit(50, 30);
    camera.lookFrom(side);
    camera.finishGlide();
    expectNear(camera.view().back, back, 1e-9);
    expectNear(camera.view().up, up, 1e-9);
    camera.setUpAxis(UpAxis::Y);  // the same view of a scene lying on its back
    camera.lookFrom(side);
    camera.finishGlide();
    expectNear(camera.toTurntable(camera.view().back), back, 1e-9);
  }
  OrbitCamera camera = cameraOver({100, 60, 40});
  camera.lookFrom(StandardView::Iso);
  camera.finishGlide();
  expectNear(camera.view().back, glm::normalize(Vec3(1, -1, 1)), 1e-9);
}

}  // namespace
}  // namespace qrelief
