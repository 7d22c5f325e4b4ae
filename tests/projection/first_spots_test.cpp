// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/first_spots.h"

#include <cmath>
#include <optional>

#include "render/gpu_surface.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

class FirstSpots : public GlTest {
 protected:
  void SetUp() override {
    auto pass = GeometryPass::create();
    ASSERT_TRUE(pass.has_value()) << pass.error().message;
    pass_ = std::make_shared<const GeometryPass>(std::move(*pass));
  }
  /// Searches from above.
  std::optional<Vec3> spotOn(const Mesh& mesh, double sizeMm) {
    const double widthMm = boundingBox(mesh).diagonal();
    const ProjectionFrame view = makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 2 * widthMm);
    const auto spots = firstSpots(GpuSurface(pass_, {mesh, vertexNormals(mesh)}), view, widthMm, sizeMm, 5);
    EXPECT_TRUE(spots.has_value());
    if (!spots || spots->empty()) return {};
    for (std::size_t i = 0; i < spots->size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_GE(glm::length((*spots)[i].position - (*spots)[j].position), 0.3 * sizeMm);
    return spots->front().position;
  }
  std::shared_ptr<const GeometryPass> pass_;
};

TEST_F(FirstSpots, OnAPlateTheSquareFitsWithinTheEdges) {
  const auto spot = spotOn(shapes::box({100, 40, 10}), 30);
  ASSERT_TRUE(spot.has_value());
  EXPECT_NEAR(spot->z, 5, 0.1);
  EXPECT_LE(std::abs(spot->x), 100 / 2 - 30 / 2 + 4);
  EXPECT_LE(std::abs(spot->y), 40 / 2 - 30 / 2 + 4);
}

TEST_F(FirstSpots, AFlatPartIsPreferredToAWavyOne) {
  const Mesh mesh = shapes::plate(
      {120, 60}, 10, 240, 120, [](double x, double y) { return x > 0 ? 0.0 : 3 * std::sin(x / 3) * std::cos(y / 3); });
  const auto spot = spotOn(mesh, 40);
  ASSERT_TRUE(spot.has_value());
  EXPECT_GE(spot->x, 40 / 2 - 4);
}

TEST_F(FirstSpots, OnASphereItIsThePointTowardsTheCamera) {
  const auto spot = spotOn(shapes::icosphere(50, 5), 30);
  ASSERT_TRUE(spot.has_value());
  EXPECT_GT(spot->z, 50 * std::cos(0.2));
}

}  // namespace
}  // namespace qrelief
