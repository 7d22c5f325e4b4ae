// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/optimal_direction.h"

#include <cmath>
#include <numbers>

#include "base/random.h"
#include "mesh/ray.h"
#include "render/gpu_surface.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

class OptimalDirectionTest : public GlTest {
 protected:
  void SetUp() override {
    auto pass = GeometryPass::create();
    ASSERT_TRUE(pass.has_value());
    pass_ = std::make_shared<const GeometryPass>(std::move(*pass));
  }
  template <class Search>
  static Search finished(Search search) {
    for (int i = 0; i < 100; ++i) {
      const Result<bool> done = search.step();
      EXPECT_TRUE(done.has_value());
      if (!done || *done) break;
    }
    return search;
  }
  OptimalDirection search(const Mesh& mesh, Vec3 centre, Vec3 start, const DirectionOptions& options) {
    surface_.emplace(pass_, GpuMesh(mesh, vertexNormals(mesh)));
    return finished(OptimalDirection(*surface_, centre, start, {0, 1, 0}, 250, options));
  }
  double measureFrom(Vec3 centre, Vec3 normal, const DirectionOptions& options) const {
    return lookFrom(*surface_, makeFrame(centre, normal, {0, 1, 0}, 250), options)->measure;
  }
  std::shared_ptr<const GeometryPass> pass_;
  std::optional<GpuSurface> surface_;
};

TEST_F(OptimalDirectionTest, FindsTheNormalOfAPlaneFromATiltedStart) {
  const OptimalDirection direction =
      search(shapes::box({200, 200, 20}), {0, 0, 10}, {0.2, -0.1, 1}, {.sizeMm = 30, .mapTexels = 128});
  EXPECT_LT(std::acos(direction.normal().z), std::numbers::pi / 180);
}

TEST_F(OptimalDirectionTest, KeepsAStartThatIsBest) {
  const Mesh saddle = shapes::plate({80, 80}, 40, 80, 80, [](double x, double y) { return 0.01 * (x * x - y * y); });
  const OptimalDirection direction = search(saddle, {0, 0, 0}, {0, 0, 1}, {.sizeMm = 30, .mapTexels = 128});
  EXPECT_LT(glm::length(direction.normal() - Vec3(0, 0, 1)), 1e-12);
  EXPECT_EQ(direction.iterations().size(), 17u);  // the start, and four sides of 8°, 4°, 2° and 1°
}

TEST_F(OptimalDirectionTest, OverAnEdgeLiesBetweenTheTwoFaces) {
  const OptimalDirection direction =
      search(shapes::box({80, 80, 80}), {40, 0, 40}, {0.5, 0, 1}, {.sizeMm = 30, .mapTexels = 128});
  EXPECT_NEAR(direction.normal().x, direction.normal().z, 0.03);
  EXPECT_NEAR(direction.normal().y, 0, 0.02);
}

TEST_F(OptimalDirectionTest, StaysWithinItsBound) {
  const Vec3 start = glm::normalize(Vec3(std::tan(1.0), 0, 1));
  const OptimalDirection direction =
      search(shapes::box({300, 300, 20}), {0, 0, 10}, start, {.sizeMm = 20, .mapTexels = 64});
  EXPECT_LE(static_cast<int>(direction.iterations().size()), OptimalDirection::kMaxLooks);
  for (const DirectionIteration& look : direction.iterations())
    EXPECT_LE(std::acos(glm::dot(look.normal, start)), OptimalDirection::kFarthestTurn + 1e-9);
  // The result is turned towards the plane's normal as far as the bound allows, except for one last step.
  EXPECT_GT(std::acos(glm::dot(direction.normal(), start)), OptimalDirection::kFarthestTurn - 0.04);
}

TEST_F(OptimalDirectionTest, IsNeverWorseThanDepthBalancedOnGeneratedShapes) {
  Random random(21);
  int better = 0;
  for (int k = 0; k < 24; ++k) {
    const double bumps = random.uniform(0.5, 4);
    const int waves = 3 + k % 4;
    const double steep = random.uniform(0.005, 0.03);
    const Mesh mesh =
        k % 4 == 0   ? shapes::bumpySphere(40, bumps, waves, 5)
        : k % 4 == 1 ? shapes::torus(40, 18, 96, 48)
        : k % 4 == 2
            ? shapes::plate({90, 90}, 60, 60, 60,
                            [&](double x, double y) { return steep * (x * x - 0.6 * y * y) + bumps * std::sin(x / 7); })
            : shapes::box({60, 60, 40});
    const Vec3 towards(random.uniform(-20, 20), random.uniform(-20, 20), 60);
    const auto surface = closestPoint(mesh, towards);
    DirectionOptions options;
    options.sizeMm = random.uniform(12, 30);
    options.mapTexels = 128;
    surface_.emplace(pass_, GpuMesh(mesh, vertexNormals(mesh)));
    const Vec3 balanced = finished(DirectionSearch(*surface_, surface->position,
                                                   triangleNormal(mesh, surface->triangle), {0, 1, 0}, 250, options))
                              .normal();
    const Vec3 optimal =
        finished(OptimalDirection(*surface_, surface->position, balanced, {0, 1, 0}, 250, options)).normal();
    const double before = measureFrom(surface->position, balanced, options);
    const double after = measureFrom(surface->position, optimal, options);
    EXPECT_LE(after, before) << k;
    better += after < 0.99 * before ? 1 : 0;
  }
  EXPECT_GE(better, 6);
}

}  // namespace
}  // namespace qrelief
