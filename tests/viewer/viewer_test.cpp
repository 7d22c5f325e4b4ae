// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/viewer.h"

#include <cmath>

#include "mesh/ray.h"
#include "render/surface_raster.h"
#include "support/gl_test.h"
#include "support/shapes.h"
#include "viewer/build_plate.h"
#include "viewer/coloured_mesh.h"
#include "viewer/decal_bounds.h"
#include "viewer/display_mesh.h"

namespace qrelief {
namespace {

constexpr int kWidth = 240, kHeight = 180;

/// Pixels of a picture, 0 … 1, addressed by the camera's screen position (from the upper left).
struct Picture {
  std::vector<float> rgba;  // row 0 at the bottom

  Vec3 at(Vec2 pixel) const {
    const int x = static_cast<int>(pixel.x), y = kHeight - 1 - static_cast<int>(pixel.y);
    const auto i = 4 * static_cast<std::size_t>(y * kWidth + x);
    return {rgba[i], rgba[i + 1], rgba[i + 2]};
  }
  double brightness(Vec2 pixel) const { return (at(pixel).x + at(pixel).y + at(pixel).z) / 3; }
};

class ViewerTest : public GlTest {
 protected:
  void SetUp() override {
    auto viewer = Viewer::create();
    ASSERT_TRUE(viewer.has_value()) << viewer.error().message;
    viewer_ = std::make_unique<Viewer>(std::move(*viewer));
    viewer_->resize(kWidth, kHeight);
    camera_.setViewport(kWidth, kHeight);
    canvas_ = gl::Texture(kWidth, kHeight, gl::Format::RGBA32F);
    const gl::Texture* const colours[] = {&canvas_};
    auto target = gl::Framebuffer::create(colours, false);
    ASSERT_TRUE(target.has_value());
    target_ = std::move(*target);
  }
  void show(const Mesh& mesh) {
    const DisplayMesh display = splitAtCreases(mesh);
    viewer_->setMesh(std::make_shared<GpuMesh>(display.mesh, display.normals));
    camera_.setScene(boundingBox(mesh));
    camera_.fitFromDefaultSide();
  }
  /// Shows a box whose upper side has the value 1, the others 0.
  void showBoxWithValuesOnTop() {
    const DisplayMesh display = splitAtCreases(shapes::box({40, 40, 40}));
    auto mesh = std::make_shared<GpuMesh>(display.mesh, display.normals);
    std::vector<float> values(display.normals.size(), 0);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (display.normals[i].z > 0.5f) values[i] = 1;
    mesh->setValues(values);
    viewer_->setMesh(mesh);
    camera_.setScene(mesh->box());
    camera_.fitFromDefaultSide();
  }
  bool draw(double nowMs, bool always = false) {
    const auto more = viewer_->draw(camera_.view(), nowMs, &target_, always);
    EXPECT_TRUE(more.has_value());
    return more.value_or(false);
  }
  /// Draws until the picture is refined, and returns it.
  Picture refined() {
    double now = clock_;
    int frames = 0;
    while (draw(now += 200) && frames < 100) ++frames;
    EXPECT_LT(frames, 100);
    clock_ = now + 1000;
    return {target_.readRgba()};
  }
  std::unique_ptr<Viewer> viewer_;
  OrbitCamera camera_;
  gl::Texture canvas_;
  gl::Framebuffer target_;
  double clock_ = 0;
};

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

TEST_F(ViewerTest, LinesAreDrawnOverTheModelAndFaintBehindIt) {
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

TEST_F(ViewerTest, ALineThatPassesTheEyeIsCutOff) {
  show(shapes::box({40, 40, 40}));
  const CameraView view = camera_.view();
  viewer_->setLines({{{view.target, view.eye() + view.back * 1000.0 + view.up * 3.0, {1, 0, 0}, 4, 4}}, {}});
  EXPECT_LT(refined().brightness({20, 20}), 1);
  const Picture picture = refined();
  EXPECT_NEAR(picture.at({20, 20}).x, picture.at({20, 20}).y, 0.1) << "nothing away from the line";
}

/// A decal that moves over a finished picture is redrawn in its own box only.
TEST_F(ViewerTest, MovingDecalsLookLikeAFullRedraw) {
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

TEST_F(ViewerTest, TheBoxOfADecalIsNoLargerThanNecessary) {
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

TEST_F(ViewerTest, TheDecalAppearsWhereItIsProjected) {
  show(shapes::box({60, 60, 20}));
  camera_.orbit(0, 400);  // from above
  Decal decal;
  decal.frame = makeFrame({0, 0, 10}, {0, 0, 1}, {0, 1, 0}, 250);
  decal.edgeMm = 40;
  decal.size = 2;
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

TEST_F(ViewerTest, TheDecalIsOnlyOnFacetsThatFaceTheReader) {
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

TEST_F(ViewerTest, UnreachedPartsOfADecalHaveTheWarningColour) {
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

TEST_F(ViewerTest, AGhostIsFainterThanADecalAndKeepsTheRefinedPicture) {
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

TEST_F(ViewerTest, ADecalHasItsOwnColours) {
  show(shapes::box({60, 60, 20}));
  camera_.orbit(0, 400);  // from above
  Decal decal;
  decal.frame = makeFrame({0, 0, 10}, {0, 0, 1}, {0, 1, 0}, 250);
  decal.edgeMm = 40;
  decal.size = 2;
  decal.ink = {255, 0, 0, 0};
  decal.colours = {Vec3f(0.03f), Vec3f(0.56f)};
  viewer_->setDecal(decal);
  const Picture picture = refined();
  EXPECT_GT(picture.brightness(camera_.toScreen({-10, 10, 10})),
            picture.brightness(camera_.toScreen({10, -10, 10})) + 0.3);
}

TEST_F(ViewerTest, ThePlateLiesAroundTheModelWhichHidesIt) {
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

TEST_F(ViewerTest, InkAloneDarkensTheSurfaceAndHasNoPaperAndNoOutline) {
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
