// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/luminance_pass.h"

#include <cmath>
#include <numbers>

#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

/// A carved flat plate seen from so far that the rays are parallel.
class LuminancePassTest : public GlTest {
 protected:
  static constexpr double kFar = 20000;
  static constexpr int kCells = 48;

  void makePass(double cellMm, LuminanceOptions options) {
    options.radiusMm = 1000;
    const Mesh plate = shapes::box({400, 400, 10});
    auto geometry = GeometryPass::create();
    ASSERT_TRUE(geometry.has_value());
    const GpuMesh mesh(plate, vertexNormals(plate));
    const ProjectionFrame frame = makeFrame({0, 0, 5}, {0, 0, 1}, {0, 1, 0}, kFar);
    auto maps = geometry->render(mesh, frame, {cellMm * kCells, kCells * options.cellTexels});
    ASSERT_TRUE(maps.has_value());
    maps_ = std::move(*maps);
    auto pass = LuminancePass::create(maps_, kFar, options);
    ASSERT_TRUE(pass.has_value()) << pass.error().message;
    pass_ = std::move(*pass);
  }

  /// Depths of the cells whose middle satisfies `carved(x, y)`, mm from the map's middle.
  template <class Predicate>
  void carve(double cellMm, double depth, Predicate carved) {
    std::vector<float> depths(kCells * kCells, 0.0f);
    for (int row = 0; row < kCells; ++row)
      for (int column = 0; column < kCells; ++column)
        if (carved((column + 0.5 - kCells / 2.0) * cellMm, (row + 0.5 - kCells / 2.0) * cellMm))
          depths[static_cast<std::size_t>(row * kCells + column)] = static_cast<float>(depth);
    pass_.setDepths(depths);
  }

  SurfaceMaps maps_;
  LuminancePass pass_;
};

TEST_F(LuminancePassTest, AnUncarvedPlaneSeesTheWholeSky) {
  makePass(0.25, {});
  pass_.run();
  for (const float v : pass_.readVisibility()) ASSERT_NEAR(v, 1, 1e-3);
  for (const float l : pass_.readCellMeans()) ASSERT_NEAR(l, 1, 1e-3);
}

TEST_F(LuminancePassTest, ATiltedPlaneSeenInPerspectiveSeesTheWholeSky) {
  for (const double tilt : {0.2, 0.5, 0.9}) {
    const Mesh plate = shapes::box({400, 400, 10});
    auto geometry = GeometryPass::create();
    ASSERT_TRUE(geometry.has_value());
    const GpuMesh mesh(plate, vertexNormals(plate));
    const ProjectionFrame frame = makeFrame({0, 0, 5}, {std::sin(tilt), 0, std::cos(tilt)}, {0, 1, 0}, 250);
    auto maps = geometry->render(mesh, frame, {40, 256});
    ASSERT_TRUE(maps.has_value());
    auto pass = LuminancePass::create(*maps, 250, {.slices = 16, .turnSlices = false});
    ASSERT_TRUE(pass.has_value());
    pass->run();
    for (const float v : pass->readVisibility()) ASSERT_NEAR(v, 1, 0.004) << "tilt " << tilt;
  }
}

TEST_F(LuminancePassTest, ATrenchFloorSeesWhatTheClosedFormSays) {
  // Middle of an infinite trench of width w and depth d: V = sin(atan(w / 2d)).
  const double cell = 0.25, width = 8 * cell, depth = 2;
  makePass(cell, {.cellTexels = 4, .slices = 32, .turnSlices = true});
  carve(cell, depth, [&](double x, double) { return std::abs(x) < width / 2; });
  pass_.run();
  const std::vector<float> visibility = pass_.readVisibility();
  const int texels = maps_.window.texels;
  double sum = 0;
  for (int dy = 0; dy < 4; ++dy)
    for (int dx = -2; dx < 2; ++dx)
      sum += visibility[static_cast<std::size_t>((texels / 2 + dy) * texels + texels / 2 + dx)];
  // The map ends 6 mm away along the trench, where the closed form still has material: below 0.005 at this depth.
  EXPECT_NEAR(sum / 16, std::sin(std::atan(width / (2 * depth))), 0.005);
}

TEST_F(LuminancePassTest, ACircularPitFloorSeesWhatTheClosedFormSays) {
  // Middle of a pit of radius r and depth d: V = r² / (r² + d²). The pit of cells has the circle's area.
  const double cell = 0.1, radius = 1.5, depth = 1.0;
  makePass(cell, {.cellTexels = 4, .slices = 32, .turnSlices = true});
  int carvedCells = 0;
  carve(cell, depth, [&](double x, double y) {
    const bool inside = std::hypot(x, y) < radius;
    carvedCells += inside;
    return inside;
  });
  pass_.run();
  const std::vector<float> visibility = pass_.readVisibility();
  const double area = carvedCells * cell * cell / std::numbers::pi;  // effective r²
  const int texels = maps_.window.texels;
  EXPECT_NEAR(visibility[static_cast<std::size_t>(texels / 2 * texels + texels / 2)], area / (area + depth * depth),
              0.005);
}

TEST_F(LuminancePassTest, TheCheapSettingAgreesWithTheFineOneInTheCellMeans) {
  const double cell = 0.24;
  std::vector<std::vector<float>> means;
  for (const int slices : {4, 48}) {
    makePass(cell, {.cellTexels = 4, .slices = slices, .turnSlices = true});
    carve(cell, 0.6,
          [](double x, double y) { return static_cast<int>(std::floor(x / 0.72) + std::floor(y / 1.2)) % 2 == 0; });
    pass_.run();
    means.push_back(pass_.readCellMeans());
  }
  double worst = 0, sum = 0;
  for (std::size_t i = 0; i < means[0].size(); ++i) {
    worst = std::max<double>(worst, std::abs(means[0][i] - means[1][i]));
    sum += std::abs(means[0][i] - means[1][i]);
  }
  EXPECT_LT(worst, 0.03);
  EXPECT_LT(sum / static_cast<double>(means[0].size()), 0.004);
}

TEST_F(LuminancePassTest, LightBouncingInAPocketFollowsTheCavityFormula) {
  const double cell = 0.25;
  makePass(cell, {.cellTexels = 4, .slices = 8, .turnSlices = false, .albedo = 0.7f});
  carve(cell, 1, [&](double x, double y) { return std::abs(x) < 1 && std::abs(y) < 1; });
  pass_.run();
  const std::vector<float> visibility = pass_.readVisibility();
  const std::vector<float> luminance = pass_.readLuminance();
  for (std::size_t i = 0; i < visibility.size(); ++i)
    ASSERT_NEAR(luminance[i], visibility[i] / (1 - 0.7 * (1 - visibility[i])),
                5e-4);  // Mesa's software divides to 12 bits
}

TEST_F(LuminancePassTest, CellsThatAreNotSelectedKeepTheirLuminance) {
  const double cell = 0.25;
  makePass(cell, {});
  pass_.run();
  const std::vector<float> before = pass_.readCellMeans();
  carve(cell, 2, [](double x, double y) { return std::abs(x) < 1 && std::abs(y) < 1; });
  const std::uint32_t middle = kCells / 2 * kCells + kCells / 2;
  pass_.selectCells(std::vector<std::uint32_t>{middle});
  pass_.run();
  const std::vector<float> after = pass_.readCellMeans();
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (i == middle)
      EXPECT_LT(after[i], 0.7f);
    else
      ASSERT_EQ(after[i], before[i]);
  }
}

}  // namespace
}  // namespace qrelief
