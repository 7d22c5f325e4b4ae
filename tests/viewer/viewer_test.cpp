// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/viewer.h"

#include <cmath>

#include "mesh/ray.h"
#include "viewer/build_plate.h"
#include "viewer/coloured_mesh.h"
#include "viewer/viewer_fixture.h"

namespace qrelief {
namespace {

using ViewerTest = ViewerFixture;

TEST_F(ViewerTest, TheVisibleFacesOfABoxDifferAndTheTopIsBrightest) {
  show(shapes::box({40, 40, 40}));
  const Picture picture = refined();
  const double top = picture.brightness(camera_.toScreen({0, 0, 20}));
  const double front = picture.brightness(camera_.toScreen({0, -20, 0}));
  const double side = picture.brightness(camera_.toScreen({20, 0, 0}));
  EXPECT_GT(top, front + 0.03);
  EXPECT_GT(top, side + 0.03);
  EXPECT_GT(std::abs(front - side), 0.02);
}

TEST_F(ViewerTest, TheBackgroundFollowsTheTheme) {
  show(shapes::box({40, 40, 40}));
  const double light = refined().brightness({2, 2});
  viewer_->setTheme(true);
  const double dark = refined().brightness({2, 2});
  EXPECT_GT(light, 0.75);
  EXPECT_LT(dark, 0.3);
}

TEST_F(ViewerTest, OcclusionDarkensAConcaveCornerButNotAnOpenPlate) {
  // On a plate with a step, the corner at the step's foot sees little more than half the sky; light reflected by the
  // step makes up for most of what it hides.
  show(shapes::plate({80, 80}, 5, 160, 4, [](double x, double) { return x < 0 ? 5.0 : 0.0; }));
  camera_.orbit(0, 30);
  const Picture picture = refined();
  const double open = picture.brightness(camera_.toScreen({30, 0, 0}));
  const double corner = picture.brightness(camera_.toScreen({1.2, 0, 0}));
  EXPECT_LT(corner, open * 0.93);
  EXPECT_NEAR(picture.brightness(camera_.toScreen({30, 20, 0})), open, 0.02);
}

TEST_F(ViewerTest, ACutShowsASolidSectionInItsColour) {
  show(shapes::box({60, 60, 20}));
  viewer_->setCut(CuttingPlane{{0, 0, 0}, {0, -1, 0}});  // cuts away the front half
  const Picture picture = refined();
  const Vec3 section = picture.at(camera_.toScreen({0, 0, 0}));
  EXPECT_GT(section.x, section.z + 0.15);
  const Vec3 beyond = picture.at(camera_.toScreen({0, 15, 10}));  // the upper side behind the cut
  EXPECT_NEAR(beyond.x, beyond.z, 0.12);
  const Vec2 gone = camera_.toScreen({0, -29, -9});
  viewer_->setCut(std::nullopt);
  EXPECT_GT(std::abs(refined().brightness(gone) - picture.brightness(gone)), 0.1);
}

TEST_F(ViewerTest, ColoursOnlyValuesAboveZeroOnRequest) {
  showBoxWithValuesOnTop();
  const Picture plain = refined();
  viewer_->showHeat(HeatShown::AboveZero);
  const Picture heat = refined();
  const Vec3 top = heat.at(camera_.toScreen({0, 0, 20}));
  EXPECT_GT(top.x, top.z + 0.4);  // yellow
  const Vec2 front = camera_.toScreen({0, -20, 0});
  EXPECT_NEAR(heat.brightness(front), plain.brightness(front), 0.01);
}

TEST_F(ViewerTest, FacetsHaveTheirOwnColours) {
  const Mesh box = shapes::box({40, 40, 40});
  std::vector<std::optional<Colour>> colours(box.triangles.size());
  for (std::size_t t = 0; t < colours.size(); ++t) {
    const Vec3 normal = triangleNormal(box, t);
    if (normal.z > 0.5) colours[t] = Colour{200, 30, 30};
    if (normal.y < -0.5) colours[t] = Colour{0, 0, 0};
  }
  viewer_->setMesh(std::make_shared<GpuMesh>(colouredMesh(splitAtCreases(box), colours)));
  camera_.setScene(boundingBox(box));
  camera_.fitFromDefaultSide();
  viewer_->showHeat(HeatShown::Colours);
  const Picture picture = refined();
  const auto at = [&](Vec3 point) { return picture.at(camera_.toScreen(point)); };
  EXPECT_GT(at({0, 0, 20}).x, 3 * at({0, 0, 20}).y) << "red";
  EXPECT_LT(at({0, -20, 0}).x, 0.25) << "black";
  EXPECT_GT(at({0, -20, 0}).x, 0.05) << "but its shape shows";
  viewer_->showHeat(HeatShown::None);
  EXPECT_NEAR(refined().at(camera_.toScreen({0, 0, 20})).x, refined().at(camera_.toScreen({0, 0, 20})).y, 0.05);
}

TEST_F(ViewerTest, MarksOverhangsButNotTheFaceOnThePlate) {
  // Seen from below: the lower side of a box hangs over the plate under a larger model.
  const Mesh box = shapes::box({40, 40, 40});
  show(box);
  camera_.orbit(0, -120);
  const auto redness = [&](const BuildPlate& plate) {
    viewer_->setPlate(plate);
    const Vec3 colour = refined().at(camera_.toScreen({3, 3, -20}));
    return colour.x / colour.z;
  };
  BuildPlate plate = plateUnder(box, {0, 0, 1});
  const double onPlate = redness(plate);
  plate.centre.z -= 400;  // out of sight
  EXPECT_GT(redness(plate), 1.3 * onPlate);
  plate.up = {std::sqrt(1 - 0.64 * 0.64), 0, 0.64};  // the side now hangs by 40° only
  EXPECT_NEAR(redness(plate), onPlate, 0.05);
}

TEST_F(ViewerTest, TheRayThroughAPixelHitsTheSurfaceItShows) {
  const Mesh sphere = shapes::icosphere(30, 5);
  show(sphere);
  viewer_->setMarker(Vec3(0, 0, 30));
  const Picture picture = refined();
  const Vec2 marked = camera_.toScreen({0, 0, 30});
  const Vec3 colour = picture.at(marked);
  EXPECT_GT(colour.z, colour.x + 0.2);  // the marker is blue
  const Ray ray = camera_.ray(marked.x, marked.y);
  const auto hit = firstHit(sphere, ray.origin, ray.direction);
  ASSERT_TRUE(hit.has_value());
  EXPECT_LT(glm::length(hit->position - Vec3(0, 0, 30)), 0.05);
}

TEST_F(ViewerTest, TheInsideOfAnOpenModelIsReddish) {
  Mesh open = shapes::box({40, 40, 40});
  open.triangles.erase(open.triangles.begin() + 2, open.triangles.begin() + 4);  // the upper side
  show(open);
  camera_.orbit(0, 1000);
  const Vec3 colour = refined().at(camera_.toScreen({0, 0, -20}));
  EXPECT_GT(colour.x, 1.3 * colour.z);
}

TEST_F(ViewerTest, RefinementWaitsUntilTheCameraRestsAndThenEnds) {
  show(shapes::box({40, 40, 40}));
  EXPECT_TRUE(draw(0));
  EXPECT_TRUE(draw(50));
  EXPECT_EQ(viewer_->statistics().samples, 0);
  camera_.orbit(5, 0);
  EXPECT_TRUE(draw(130));
  EXPECT_TRUE(draw(200));
  EXPECT_EQ(viewer_->statistics().samples, 0);
  EXPECT_TRUE(draw(260));
  EXPECT_EQ(viewer_->statistics().samples, 0) << "shows codes and the plate sharply at first";
  EXPECT_TRUE(draw(270));
  EXPECT_EQ(viewer_->statistics().samples, 1);
  EXPECT_EQ(viewer_->statistics().width, kWidth);
  int frames = 1;
  double now = 300;
  while (draw(now += 10) && frames < 100) ++frames;
  EXPECT_EQ(viewer_->statistics().samples, ViewQuality{}.stillSamples);
  EXPECT_FALSE(draw(now + 10));
  camera_.orbit(5, 0);
  EXPECT_TRUE(draw(now + 20));
  EXPECT_EQ(viewer_->statistics().width, kWidth / 2);
}

TEST_F(ViewerTest, SlowFramesInMotionLowerTheResolution) {
  show(shapes::box({40, 40, 40}));
  for (double now = 0; now < 2000; now += 100) {
    camera_.orbit(1, 0);
    draw(now);
  }
  EXPECT_EQ(viewer_->statistics().width, static_cast<int>(std::lround(0.4 * kWidth)));
  EXPECT_NEAR(viewer_->statistics().coarseFrameMs, 100, 1);
}

TEST_F(ViewerTest, FastFramesInMotionRestoreTheResolution) {
  show(shapes::box({40, 40, 40}));
  double now = 0;
  const auto move = [&](double intervalMs, int frames) {
    for (int i = 0; i < frames; ++i) {
      camera_.orbit(1, 0);
      draw(now += intervalMs);
    }
  };
  move(100, 20);
  EXPECT_LT(viewer_->statistics().width, kWidth / 2);
  move(10, 100);
  EXPECT_EQ(viewer_->statistics().width, kWidth / 2);
}

TEST_F(ViewerTest, DrawsATooLargeCanvasCoarserButFillsIt) {
  show(shapes::box({40, 40, 40}));
  viewer_->resize(2000, 1600);
  double now = 0;
  while (draw(now += 200)) {
  }
  EXPECT_LE(viewer_->statistics().width * viewer_->statistics().height, 1.01 * ViewQuality{}.mostPixels);
  EXPECT_NEAR(static_cast<double>(viewer_->statistics().width) / viewer_->statistics().height, 1.25, 0.01);
}

TEST_F(ViewerTest, DrawsOnlyTheBackgroundWithoutAModel) {
  const Picture picture = refined();
  EXPECT_NEAR(picture.brightness({10, 90}), picture.brightness({200, 90}), 0.01);
}

TEST_F(ViewerTest, RefinementIsPresentedAtEveryFourthPictureUnlessMoreIsDrawnOnTop) {
  show(shapes::box({40, 40, 40}));
  const auto presents = [&](double nowMs, bool always) {
    target_.bind();
    glClearColor(1, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    draw(nowMs, always);
    const Vec3 colour = Picture{target_.readRgba()}.at({2, 2});
    return colour.y > 0.1;  // no longer magenta
  };
  EXPECT_TRUE(presents(0, false));
  EXPECT_TRUE(presents(150, false)) << "codes and the plate sharply";
  double now = 200;
  for (int sample = 1; sample <= ViewQuality{}.stillSamples; ++sample, now += 10) {
    EXPECT_EQ(presents(now, false), sample % 4 == 0) << sample;
    EXPECT_EQ(viewer_->statistics().samples, sample);
  }
  EXPECT_FALSE(presents(now, false));
  EXPECT_TRUE(presents(now, true));
}

}  // namespace
}  // namespace qrelief
