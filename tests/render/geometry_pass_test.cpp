// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/geometry_pass.h"

#include <cmath>

#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

class GeometryPassTest : public GlTest {
 protected:
  void SetUp() override {
    auto pass = GeometryPass::create();
    ASSERT_TRUE(pass.has_value()) << pass.error().message;
    pass_ = std::move(*pass);
  }
  static GpuMesh upload(const Mesh& mesh) { return {mesh, vertexNormals(mesh)}; }
  GeometryPass pass_;
};

TEST_F(GeometryPassTest, ASphereHasItsClosedFormDistancesAndNormals) {
  const double radius = 30;
  const GpuMesh sphere = upload(shapes::icosphere(radius, 6));
  const ProjectionFrame frame = makeFrame({0, 0, radius}, {0, 0, 1}, {0, 1, 0}, 250);
  const MapWindow window{30, 128};
  const auto maps = pass_.render(sphere, frame, window);
  ASSERT_TRUE(maps.has_value()) << maps.error().message;
  const std::vector<float> surface = maps->framebuffer.readRgba(0);
  const std::vector<float> smooth = maps->framebuffer.readRgba(1);

  double worstDistance = 0, worstHeight = 0, worstSmooth = 0;
  for (int row = 0; row < 128; ++row) {
    for (int column = 0; column < 128; ++column) {
      const auto i = 4 * static_cast<std::size_t>(row * 128 + column);
      const Vec3 ray = frame.rayDirection(window.planePoint(column, row));
      // |eye + t·ray| = radius, the nearer root.
      const double b = glm::dot(frame.eye(), ray);
      const double t = -b - std::sqrt(b * b - glm::dot(frame.eye(), frame.eye()) + radius * radius);
      const Vec3 normal = (frame.eye() + t * ray) / radius;
      worstDistance = std::max(worstDistance, std::abs(smooth[i + 3] - t));
      worstHeight = std::max(worstHeight, std::abs(surface[i + 3] - (radius * normal.z - radius)));
      worstSmooth = std::max(worstSmooth, glm::length(Vec3(smooth[i], smooth[i + 1], smooth[i + 2]) - normal));
    }
  }
  // An icosphere of level 6 has edges of 0.6 mm. Its facets lie up to 0.6²/(8·30)·4/3 = 0.002 mm below the sphere,
  // and the eye sees them at 45° at the window's corners.
  EXPECT_LT(worstDistance, 0.005);
  EXPECT_LT(worstHeight, 0.005);
  EXPECT_LT(worstSmooth, 0.003);
}

TEST_F(GeometryPassTest, ASmallWindowOnALargeMeshMissesNoFacet) {
  // The pass draws only clusters of facets near the window; wherever it wrongly left one out, the map would have a
  // hole.
  const double radius = 30;
  const GpuMesh sphere = upload(shapes::icosphere(radius, 6));
  for (const Vec3 towards : {Vec3(1, 0, 0), Vec3(-0.3, 0.8, 0.2), Vec3(0.5, -0.5, -0.7), Vec3(0, -1, 0.1)}) {
    for (const double extent : {3.0, 11.0, 20.0}) {
      const Vec3 normal = glm::normalize(towards);
      const ProjectionFrame frame = makeFrame(normal * radius, normal, {0, 0, 1}, 90);
      const auto maps = pass_.render(sphere, frame, {extent, 64});
      ASSERT_TRUE(maps.has_value());
      const std::vector<float> smooth = maps->framebuffer.readRgba(1);
      double worst = 0;
      for (int row = 0; row < 64; ++row) {
        for (int column = 0; column < 64; ++column) {
          const Vec3 ray = frame.rayDirection(MapWindow{extent, 64}.planePoint(column, row));
          const double b = glm::dot(frame.eye(), ray);
          const double t = -b - std::sqrt(b * b - glm::dot(frame.eye(), frame.eye()) + radius * radius);
          worst = std::max(worst, std::abs(smooth[4 * static_cast<std::size_t>(row * 64 + column) + 3] - t));
        }
      }
      EXPECT_LT(worst, 0.01) << extent;
    }
  }
}

TEST_F(GeometryPassTest, FacetNormalsAreNotInterpolated) {
  const GpuMesh box = upload(shapes::box({40, 40, 20}));
  const ProjectionFrame frame = makeFrame({0, 0, 10}, {0, 0, 1}, {0, 1, 0}, 250);
  const auto maps = pass_.render(box, frame, {30, 64});
  ASSERT_TRUE(maps.has_value());
  const std::vector<float> surface = maps->framebuffer.readRgba(0);
  const std::vector<float> smooth = maps->framebuffer.readRgba(1);
  for (std::size_t i = 0; i < surface.size(); i += 4) {
    EXPECT_NEAR(surface[i], 0, 1e-5);
    EXPECT_NEAR(surface[i + 1], 0, 1e-5);
    EXPECT_NEAR(surface[i + 2], 1, 1e-5);
  }
  EXPECT_GT(std::abs(smooth[0]), 0.1f);  // the corner's smooth normal leans outwards
}

TEST_F(GeometryPassTest, RaysThatMissTheModelAreZero) {
  const GpuMesh box = upload(shapes::box({10, 10, 10}));
  const ProjectionFrame frame = makeFrame({0, 0, 5}, {0, 0, 1}, {0, 1, 0}, 250);
  const auto maps = pass_.render(box, frame, {20, 100});
  ASSERT_TRUE(maps.has_value());
  const std::vector<float> surface = maps->framebuffer.readRgba(0);
  int inside = 0;
  for (std::size_t i = 2; i < surface.size(); i += 4) inside += surface[i] > 0;
  EXPECT_EQ(inside, 50 * 50);
}

TEST_F(GeometryPassTest, TheBackDistanceGivesTheThicknessOfAPlate) {
  const GpuMesh plate = upload(shapes::box({60, 60, 3}));
  const ProjectionFrame frame = makeFrame({0, 0, 1.5}, {0, 0, 1}, {0, 1, 0}, 250);
  const MapWindow window{30, 32};
  const auto front = pass_.render(plate, frame, window);
  const auto back = pass_.renderBack(plate, frame, window);
  ASSERT_TRUE(front.has_value() && back.has_value());
  const std::vector<float> ahead = front->framebuffer.readRgba(1);
  const std::vector<float> behind = back->framebuffer.readRed();
  for (int row = 0; row < 32; ++row) {
    for (int column = 0; column < 32; ++column) {
      const auto i = static_cast<std::size_t>(row * 32 + column);
      const double slant = 1 / -frame.rayDirection(window.planePoint(column, row)).z;
      EXPECT_NEAR(behind[i] - ahead[4 * i + 3], 3 * slant, 1e-4);
    }
  }
}

TEST_F(GeometryPassTest, AModelFarFromTheOriginKeepsItsDigits) {
  const Vec3 far(4000, -3000, 2000);
  const Mesh box = shapes::translated(shapes::box({40, 40, 20}), far);
  const ProjectionFrame frame = makeFrame(far + Vec3(0, 0, 10), {0, 0, 1}, {0, 1, 0}, 250);
  const auto maps = pass_.render(upload(box), frame, {30, 64});
  ASSERT_TRUE(maps.has_value());
  const std::vector<float> smooth = maps->framebuffer.readRgba(1);
  EXPECT_NEAR(smooth[4 * (32 * 64 + 32) + 3], 250, 5e-4);  // 32-bit positions hold 2.4e-4 mm at 4 m
}

}  // namespace
}  // namespace qrelief
