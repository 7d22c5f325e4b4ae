// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "mesh/ray.h"
#include "render/surface_raster.h"
#include "viewer/build_plate.h"
#include "viewer/decal_bounds.h"
#include "viewer/viewer_fixture.h"

namespace qrelief {
namespace {

using ViewerPresentTest = ViewerFixture;

/// Returns a decal of two by two modules without ink, for the top of a box 20 mm high.
Decal decalOnTop() {
  Decal decal;
  decal.frame = makeFrame({0, 0, 10}, {0, 0, 1}, {0, 1, 0}, 250);
  decal.edgeMm = 40;
  decal.size = 2;
  return decal;
}

TEST_F(ViewerPresentTest, LinesAreDrawnOverTheModelAndFaintBehindIt) {
  show(shapes::box({40, 40, 40}));
  camera_.lookFrom(StandardView::Front);
  camera_.finishGlide();
  const Picture without = refined();
  const Vec3f red(1, 0, 0);
  viewer_->setLines({{{{-15, -25, 10}, {15, -25, 10}, red, 6, 6}, {{-15, 25, -10}, {15, 25, -10}, red, 6, 6}}, {}});
  const Picture with = refined();
  const auto redness = [&](Vec3 point) {
    const Vec2 pixel = camera_.toScreen(point);
    return (with.at(pixel).x - with.at(pixel).y) - (without.at(pixel).x - without.at(pixel).y);
  };
  EXPECT_GT(redness({0, -25, 10}), 0.9);
  EXPECT_GT(redness({0, 25, -10}), 0.1);
  EXPECT_LT(redness({0, 25, -10}), 0.4);
  EXPECT_NEAR(redness({18, -25, 10}), 0, 0.01) << "beside its end";
  viewer_->setLines({});
  EXPECT_NEAR(glm::distance(refined().at(camera_.toScreen({0, -25, 10})), without.at(camera_.toScreen({0, -25, 10}))),
              0, 0.01);
}

TEST_F(ViewerPresentTest, ALineThatPassesTheEyeIsCutOff) {
  show(shapes::box({40, 40, 40}));
  const CameraView view = camera_.view();
  viewer_->setLines({{{view.target, view.eye() + view.back * 1000.0 + view.up * 3.0, {1, 0, 0}, 4, 4}}, {}});
  EXPECT_LT(refined().brightness({20, 20}), 1);
  const Picture picture = refined();
  EXPECT_NEAR(picture.at({20, 20}).x, picture.at({20, 20}).y, 0.1) << "nothing away from the line";
}

TEST_F(ViewerPresentTest, InkHasOtherShadesUnderLamps) {
  show(shapes::box({40, 40, 20}));
  camera_.lookFrom(StandardView::Top);
  camera_.finishGlide();
  Decal decal = decalOnTop();
  decal.ink = {255, 0, 0, 0};
  decal.inkUnderLamps = {0, 0, 0, 255};
  const Vec2 upperLeft = camera_.toScreen({-10, 10, 10}), lowerRight = camera_.toScreen({10, -10, 10});
  const auto expectInkAt = [&](Vec2 ink, Vec2 paper) {
    const Picture picture = refined();
    EXPECT_LT(picture.brightness(ink), 0.5 * picture.brightness(paper));
  };
  viewer_->setDecal(decal);
  expectInkAt(upperLeft, lowerRight);
  viewer_->setLight(LampLight{{{Vec3(0, 0, 1), 1}}, 2, 0.7, {}, 30});
  expectInkAt(lowerRight, upperLeft);
  decal.inkUnderLamps = {};
  viewer_->setDecal(decal);
  expectInkAt(upperLeft, lowerRight);
  viewer_->setLight({});
  expectInkAt(upperLeft, lowerRight);
}

/// A part of the canvas's pixels is drawn while something changes, and all of them once it rests.
TEST_F(ViewerPresentTest, CodesAreCoarseInMotionAndSharpAtRest) {
  show(shapes::box({40, 40, 20}));
  camera_.lookFrom(StandardView::Top);
  camera_.finishGlide();
  Decal decal = decalOnTop();
  decal.ink = {255, 0, 0, 255};
  viewer_->setDecal(decal);
  const Vec2 middle = camera_.toScreen({0, 0, 10});
  const auto pixelsOfTheEdge = [&](const Picture& picture) {  // between ink on the left and paper on the right
    const Vec2 row = middle + Vec2(0, -10);
    const double dark = picture.brightness(row - Vec2(8, 0)), light = picture.brightness(row + Vec2(8, 0));
    EXPECT_LT(dark, 0.5 * light);
    int between = 0;
    for (int x = -8; x <= 8; ++x) {
      const double shade = (picture.brightness(row + Vec2(x, 0)) - dark) / (light - dark);
      between += shade > 0.1 && shade < 0.9 ? 1 : 0;
    }
    return between;
  };
  EXPECT_TRUE(draw(0));
  const int inMotion = pixelsOfTheEdge(Picture{target_.readRgba()});
  EXPECT_TRUE(draw(200));
  EXPECT_EQ(viewer_->statistics().samples, 0) << "nothing is refined yet";
  const int atRest = pixelsOfTheEdge(Picture{target_.readRgba()});
  EXPECT_GT(inMotion, atRest);
  EXPECT_LE(atRest, 1);
}

/// A decal that moves over a finished picture is redrawn in its own box only.
TEST_F(ViewerPresentTest, MovingDecalsLookLikeAFullRedraw) {
  const Mesh mesh = shapes::bumpySphere(30, 2, 4, 5);
  show(mesh);
  const SurfaceRaster seen(mesh);
  const auto decalAt = [&](Vec3 direction, bool withReach) {
    Decal decal;
    const auto hit = firstHit(mesh, direction * 100.0, -direction);
    EXPECT_TRUE(hit.has_value());
    decal.frame = makeFrame(hit->position, direction, {0, 0, 1}, 250);
    decal.edgeMm = 24;
    decal.size = 2;
    decal.ink = {255, 0, 0, 255};
    if (!withReach) return decal;
    auto reach = lookAround(seen, decal.frame, {50, 96});
    EXPECT_TRUE(reach.has_value());
    decal.reach = std::make_shared<const VisibilityMap>(std::move(*reach));
    return decal;
  };
  for (int k = 0; k < 6; ++k) {
    const double angle = k * 1.1;
    const Vec3 towards = glm::normalize(Vec3(std::cos(angle), std::sin(angle), 0.3 * k - 0.7));
    const Vec3 beside = glm::normalize(towards + Vec3(0, 0.3, 0.4));
    camera_.orbit(60.0 * k, 25);
    viewer_->setDecal(decalAt(towards, k % 2 == 0));
    viewer_->setGhost(std::nullopt);
    refined();
    viewer_->setGhost(decalAt(beside, k % 3 != 0));
    draw(clock_ += 1);
    if (k % 2 == 1) {  // moves the other decal
      viewer_->setGhost(std::nullopt);
      draw(clock_ += 1);
      viewer_->setDecal(decalAt(beside, true));
      draw(clock_ += 1);
    }
    const Picture moved{target_.readRgba()};
    ASSERT_TRUE(viewer_->draw(camera_.view(), clock_ += 1, &target_, true).has_value());
    const Picture whole{target_.readRgba()};
    double different = 0;
    for (std::size_t i = 0; i < whole.rgba.size(); ++i)
      different = std::max<double>(different, std::abs(moved.rgba[i] - whole.rgba[i]));
    EXPECT_LT(different, 2.0 / 255) << k;  // the picture is stored as bytes, with and without the other decal
  }
}

TEST_F(ViewerPresentTest, TheBoxOfADecalIsNoLargerThanNecessary) {
  show(shapes::box({60, 60, 20}));
  camera_.orbit(0, 400);  // from above
  Decal decal;
  decal.frame = makeFrame({0, 0, 10}, {0, 0, 1}, {0, 1, 0}, 250);
  decal.edgeMm = 20;
  auto reach = std::make_shared<VisibilityMap>();
  reach->frame = decal.frame;
  reach->window = {40, 64};
  reach->texels.assign(4 * 64 * 64, 0.0f);
  decal.reach = reach;
  const PixelBox box = decalBounds(decal, camera_.view(), kWidth, kHeight);
  Vec2 low(1e9), high(-1e9);
  for (const Vec3 corner : {Vec3(10, 10, 10), Vec3(-10, 10, 10), Vec3(-10, -10, 10), Vec3(10, -10, 10)}) {
    low = glm::min(low, camera_.toScreen(corner));
    high = glm::max(high, camera_.toScreen(corner));
  }
  EXPECT_GE(box.width, high.x - low.x);
  EXPECT_LE(box.width, high.x - low.x + 24);
  EXPECT_GE(box.height, high.y - low.y);
  EXPECT_LE(box.height, high.y - low.y + 24);
  decal.frame = makeFrame({0, 0, 1000}, {0, 0, 1}, {0, 1, 0}, 250);  // behind the camera
  EXPECT_EQ(decalBounds(decal, camera_.view(), kWidth, kHeight), (PixelBox{0, 0, kWidth, kHeight}));
}

TEST_F(ViewerPresentTest, TheDecalAppearsWhereItIsProjected) {
  show(shapes::box({60, 60, 20}));
  camera_.orbit(0, 400);  // from above
  Decal decal = decalOnTop();
  decal.ink = {255, 0,  // the viewer's upper left is dark
               0, 0};
  viewer_->setDecal(decal);
  const Picture with = refined();
  const double ink = with.brightness(camera_.toScreen({-10, 10, 10}));
  for (const Vec3 paper : {Vec3(10, 10, 10), Vec3(-10, -10, 10), Vec3(10, -10, 10)})
    EXPECT_GT(with.brightness(camera_.toScreen(paper)), ink + 0.4);
  const double plain = with.brightness(camera_.toScreen({26, 0, 10}));
  EXPECT_GT(with.brightness(camera_.toScreen({10, 10, 10})), plain + 0.03);

  viewer_->setDecal(std::nullopt);
  EXPECT_GT(refined().brightness(camera_.toScreen({-10, 10, 10})), ink + 0.3);
}

TEST_F(ViewerPresentTest, TheDecalIsOnlyOnFacetsThatFaceTheReader) {
  show(shapes::box({60, 60, 20}));
  Decal decal;
  decal.frame = makeFrame({0, 0, 10}, {0, 0, 1}, {0, 1, 0}, 250);
  decal.edgeMm = 80;  // past the edges, where the sides begin
  decal.size = 1;
  decal.ink = {255};
  const Vec2 front = camera_.toScreen({0, -30, 0});
  const double before = refined().brightness(front);
  viewer_->setDecal(decal);
  const Picture with = refined();
  EXPECT_NEAR(with.brightness(front), before, 0.01);
  EXPECT_LT(with.brightness(camera_.toScreen({0, 0, 10})), 0.35);
}

TEST_F(ViewerPresentTest, UnreachedPartsOfADecalHaveTheWarningColour) {
  show(shapes::box({60, 60, 20}));
  camera_.orbit(0, 400);  // from above
  auto reach = std::make_shared<VisibilityMap>();
  reach->frame = makeFrame({20, 0, 10}, {0, 0, 1}, {0, 1, 0}, 250);
  reach->window = {60, 64};
  for (int row = 0; row < 64; ++row) {
    for (int column = 0; column < 64; ++column) {
      const double x = 20 + reach->window.planePoint(column, row).x;
      const bool isMet = x < 30;
      for (const float value : {isMet ? 0.0f : VisibilityMap::kNothing, x < 25 ? 1.0f : 0.0f, 0.0f, 0.0f})
        reach->texels.push_back(value);
    }
  }
  Decal decal;
  decal.frame = reach->frame;
  decal.edgeMm = 40;
  decal.size = 1;
  decal.ink = {255};
  decal.reach = reach;
  viewer_->setDecal(decal);
  const Picture picture = refined();
  EXPECT_LT(picture.brightness(camera_.toScreen({15, 5, 10})), 0.35);  // the decal reaches this point: ink
  for (const Vec3 missing : {Vec3(28, 5, 10), Vec3(35, 5, 10)}) {      // on the model, and over its edge
    const Vec3 colour = picture.at(camera_.toScreen(missing));
    EXPECT_GT(colour.x, colour.z + 0.1) << missing.x;
  }
}

TEST_F(ViewerPresentTest, AGhostIsFainterThanADecalAndKeepsTheRefinedPicture) {
  show(shapes::box({60, 60, 20}));
  camera_.orbit(0, 400);
  const Vec2 inside = camera_.toScreen({0, 0, 10}), outside = camera_.toScreen({25, 25, 10});
  const Picture plain = refined();
  const int samples = viewer_->statistics().samples;
  Decal decal;
  decal.frame = makeFrame({0, 0, 10}, {0, 0, 1}, {0, 1, 0}, 250);
  decal.edgeMm = 20;
  decal.size = 1;
  decal.ink = {255};
  viewer_->setGhost(decal);
  EXPECT_FALSE(draw(clock_ + 1));
  const Picture ghost{target_.readRgba()};
  EXPECT_EQ(viewer_->statistics().samples, samples);
  EXPECT_NEAR(ghost.brightness(outside), plain.brightness(outside), 1.0 / 255);
  viewer_->setGhost(std::nullopt);
  viewer_->setDecal(decal);
  EXPECT_FALSE(draw(clock_ + 2));
  const Picture printed{target_.readRgba()};
  EXPECT_LT(printed.brightness(inside), ghost.brightness(inside) - 0.05);
  EXPECT_LT(ghost.brightness(inside), plain.brightness(inside) - 0.1);
}

TEST_F(ViewerPresentTest, ADecalHasItsOwnColours) {
  show(shapes::box({60, 60, 20}));
  camera_.orbit(0, 400);  // from above
  Decal decal = decalOnTop();
  decal.ink = {255, 0, 0, 0};
  decal.colours = {Vec3f(0.03f), Vec3f(0.56f)};
  viewer_->setDecal(decal);
  const Picture picture = refined();
  EXPECT_GT(picture.brightness(camera_.toScreen({-10, 10, 10})),
            picture.brightness(camera_.toScreen({10, -10, 10})) + 0.3);
}

TEST_F(ViewerPresentTest, ThePlateLiesAroundTheModelWhichHidesIt) {
  const Mesh box = shapes::box({40, 40, 40});
  show(box);
  camera_.zoom(0.5, camera_.onTargetPlane(kWidth / 2.0, kHeight / 2.0));
  const Picture before = refined();
  const BuildPlate plate = plateUnder(box, {0, 0, 1});
  viewer_->setPlate(plate);
  const Picture after = refined();
  const auto change = [&](Vec3 point) {
    const Vec2 pixel = camera_.toScreen(point);
    return glm::distance(after.at(pixel), before.at(pixel));
  };
  EXPECT_GT(change({24, -24, -20}), 0.02) << "beside the model";
  EXPECT_LT(change({0, 0, -20}), 0.01) << "under the model";
  EXPECT_LT(change({0, 0, 20}), 0.01) << "on its top";
  EXPECT_LT(change({0, 200, -20}), 0.01) << "far away";
  viewer_->setPlate({});
  const Picture without = refined();
  EXPECT_EQ(without.rgba, before.rgba);
}

TEST_F(ViewerPresentTest, InkAloneDarkensTheSurfaceAndHasNoPaperAndNoOutline) {
  const Mesh box = shapes::box({40, 40, 40});
  show(box);
  const Picture before = refined();
  Decal decal;
  decal.frame = makeFrame({0, 0, 20}, {0, 0, 1}, {0, 1, 0}, 250);
  decal.edgeMm = 30;
  decal.size = 2;
  decal.ink = {255, 0, 0, 0};  // in the upper left
  decal.isInkOnly = true;
  decal.colours.ink = Vec3f(0);
  viewer_->setDecal(decal);
  const Picture after = refined();
  const auto share = [&](Vec3 point) {
    return after.brightness(camera_.toScreen(point)) / before.brightness(camera_.toScreen(point));
  };
  EXPECT_LT(share({-8, 8, 20}), 0.05);
  EXPECT_NEAR(share({8, -8, 20}), 1, 0.02) << "no ink";
  EXPECT_NEAR(share({15, -8, 20}), 1, 0.02) << "at the decal's edge";
}

/// One code is placed while another one is under the pointer.
TEST_F(ViewerPresentTest, ADecalAndAGhostHaveTheirOwnInk) {
  show(shapes::box({60, 60, 20}));
  camera_.orbit(0, 400);
  Decal empty;
  empty.frame = makeFrame({-15, 0, 10}, {0, 0, 1}, {0, 1, 0}, 250);
  empty.edgeMm = 20;
  empty.size = 1;
  empty.ink = {0};
  Decal dark = empty;
  dark.frame = makeFrame({15, 0, 10}, {0, 0, 1}, {0, 1, 0}, 250);
  dark.ink = {255};
  viewer_->setDecal(empty);
  viewer_->setGhost(dark);
  const Picture picture = refined();
  const double placed = picture.brightness(camera_.toScreen({-15, 0, 10}));
  EXPECT_GT(placed, picture.brightness(camera_.toScreen({15, 0, 10})) + 0.1);
  dark.ink = {0};
  viewer_->setGhost(dark);
  EXPECT_NEAR(refined().brightness(camera_.toScreen({15, 0, 10})), placed, 0.1);
}

}  // namespace
}  // namespace qrelief
