// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/visibility_map.h"

#include <cmath>
#include <numbers>

#include "render/gpu_surface.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

class EyeReachTest : public GlTest {
 protected:
  void SetUp() override {
    auto pass = GeometryPass::create();
    ASSERT_TRUE(pass.has_value()) << pass.error().message;
    pass_ = std::make_shared<const GeometryPass>(std::move(*pass));
  }
  VisibilityMap look(const Mesh& mesh, Vec3 centre, double extentMm) {
    const GpuSurface surface(pass_, GpuMesh(mesh, vertexNormals(mesh)));
    auto reach = lookAround(surface, makeFrame(centre, {0, 0, 1}, {0, 1, 0}, 250), {extentMm, 128});
    EXPECT_TRUE(reach.has_value());
    return *reach;
  }
  std::shared_ptr<const GeometryPass> pass_;
};

TEST_F(EyeReachTest, SquaresOnTopOfABoxMatchTheClosedFormToATexel) {
  const VisibilityMap reach = look(shapes::box({60, 60, 20}), {0, 0, 10}, 100);
  const double texel = reach.window.texelMm();
  EXPECT_NEAR(reach.freeMm(), std::numbers::sqrt2 * 30, 2 * texel);
  EXPECT_NEAR(reach.alignedMm(0), 60, 2 * texel);
  EXPECT_NEAR(reach.alignedMm(std::numbers::pi / 4), std::numbers::sqrt2 * 30, 2 * texel);
}

TEST_F(EyeReachTest, TheMissingFractionIsTheFractionOfTheArea) {
  const VisibilityMap reach = look(shapes::box({60, 60, 20}), {10, 0, 10}, 100);
  EXPECT_EQ(reach.missingFraction(38, 0), 0);
  // 10 mm of a 60 mm square about the centre lie beyond the edge.
  EXPECT_NEAR(reach.missingFraction(60, 0), 1 / 6.0, 0.03);
}

TEST_F(EyeReachTest, TheBendIsThatOfTheSurfaceUnderTheTurnedSquare) {
  // A step of 2 mm at x = 8: a square that ends before it is flat, one beyond it or turned into it is not.
  const Mesh plate = shapes::plate({60, 60}, 10, 60, 12, [](double x, double) { return x < 8 ? 0.0 : 2.0; });
  const VisibilityMap reach = look(plate, {0, 0, 0}, 60);
  EXPECT_NEAR(reach.bendMm(14, 0), 0, 1e-3);
  EXPECT_GT(reach.bendMm(14, std::numbers::pi / 4), 0.05);
  EXPECT_GT(reach.bendMm(24, 0), 0.2);
}

TEST_F(EyeReachTest, ASeparatePartIsVisibleButNotConnected) {
  const Mesh two =
      shapes::together(shapes::box({20, 20, 20}), shapes::translated(shapes::box({20, 20, 20}), {25, 0, 0}));
  VisibilityMap reach = look(two, {0, 0, 10}, 80);
  const auto texel = [&](double x) { return static_cast<int>((x / 80 + 0.5) * 128); };
  EXPECT_TRUE(reach.isReached(texel(8), 64));
  EXPECT_FALSE(reach.isReached(texel(25), 64));
  reach.trust();
  EXPECT_TRUE(reach.isReached(texel(25), 64));
}

TEST_F(EyeReachTest, NothingIsConnectedToAHiddenCentre) {
  const Mesh two =
      shapes::together(shapes::box({20, 20, 20}), shapes::translated(shapes::box({20, 20, 2}), {0, 0, 60}));
  const VisibilityMap reach = look(two, {0, 0, 10}, 40);
  EXPECT_LT(reach.freeMm(), reach.window.texelMm());
  EXPECT_EQ(reach.missingFraction(10, 0), 1);
}

}  // namespace
}  // namespace qrelief
