// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/luminance_pass.h"

#include <cmath>
#include <numbers>

#include "math/angle.h"
#include "mesh/ray_tree.h"
#include "study/path_tracer.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

/// Fixture with a carved flat plate, seen from so far away that the rays are parallel.
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
    auto maps = geometry->render(mesh, frame, {cellMm * cells_, cells_ * options.cellTexels});
    ASSERT_TRUE(maps.has_value());
    maps_ = std::move(*maps);
    auto pass = LuminancePass::create(maps_, nullptr, kFar, options);
    ASSERT_TRUE(pass.has_value()) << pass.error().message;
    pass_ = std::move(*pass);
  }

  /// Carves the cells whose middle, mm from the map's middle, satisfies `carved(x, y)`.
  template <class Predicate>
  void carve(double cellMm, double depth, Predicate carved) {
    std::vector<float> depths(static_cast<std::size_t>(cells_ * cells_), 0.0f);
    for (int row = 0; row < cells_; ++row)
      for (int column = 0; column < cells_; ++column)
        if (carved((column + 0.5 - cells_ / 2.0) * cellMm, (row + 0.5 - cells_ / 2.0) * cellMm))
          depths[static_cast<std::size_t>(row * cells_ + column)] = static_cast<float>(depth);
    pass_.setDepths(depths);
  }

  int cells_ = kCells;
  SurfaceMaps maps_;
  LuminancePass pass_;
};

TEST_F(LuminancePassTest, AnUncarvedPlaneSeesTheWholeSky) {
  makePass(0.25, {});
  pass_.run();
  for (const Received& r : pass_.readReceived()) ASSERT_NEAR(r.sky, 1, 1e-3);
  for (const float l : pass_.readLuminance()) ASSERT_NEAR(l, 1, 1e-3);
}

TEST_F(LuminancePassTest, ATiltedPlaneSeenInPerspectiveSeesTheWholeSkyAndALampByItsCosine) {
  for (const double tilt : {0.2, 0.5, 0.9}) {
    const Mesh plate = shapes::box({400, 400, 10});
    auto geometry = GeometryPass::create();
    ASSERT_TRUE(geometry.has_value());
    const GpuMesh mesh(plate, vertexNormals(plate));
    const ProjectionFrame frame = makeFrame({0, 0, 5}, {std::sin(tilt), 0, std::cos(tilt)}, {0, 1, 0}, 250);
    auto maps = geometry->render(mesh, frame, {40, 256});
    ASSERT_TRUE(maps.has_value());
    // A low lamp behind the plane's upper edge: 0.1 rad over the plane.
    const DirectionalLight lamp{.azimuthDeg = 0, .elevationDeg = toDegrees(tilt + 0.1)};
    auto pass =
        LuminancePass::create(*maps, nullptr, 250, {.sampling = {4, 16}, .turnSlices = false, .lights = {lamp}});
    ASSERT_TRUE(pass.has_value());
    pass->run();
    for (const Received& r : pass->readReceived()) ASSERT_NEAR(r.sky, 1, 0.004) << "tilt " << tilt;

    // Carved all over, it is such a plane, too.
    pass->setDepths(std::vector<float>(pass->readLuminance().size(), 0.3f));
    pass->run();
    for (const Received& r : pass->readReceived()) ASSERT_NEAR(r.lamps, std::sin(0.1), 2e-3) << "tilt " << tilt;
  }
}

TEST_F(LuminancePassTest, ATrenchFloorMatchesTheClosedForm) {
  // At x in an infinite trench between walls at ±w/2, V = (sin(atan((w/2 + x)/d)) + sin(atan((w/2 - x)/d))) / 2. Its
  // integral over x is a difference of √(u² + d²).
  const double cell = 0.25, width = 8 * cell, depth = 1;
  makePass(cell, {.cellTexels = 4, .sampling = {4, 16}});
  carve(cell, depth, [&](double x, double) { return std::abs(x) < width / 2; });
  pass_.run();
  const auto integral = [&](double x) {
    return (std::hypot(width / 2 + x, depth) - std::hypot(width / 2 - x, depth)) / 2;
  };
  const std::vector<Received> received = pass_.readReceived();
  for (int column = -4; column < 4; ++column)
    EXPECT_NEAR(received[static_cast<std::size_t>(kCells / 2 * kCells + kCells / 2 + column)].sky,
                (integral((column + 1) * cell) - integral(column * cell)) / cell, 0.005)
        << column;
}

TEST_F(LuminancePassTest, ACircularPitFloorMatchesTheClosedForm) {
  // The middle of a pit of radius r and depth d has V = r² / (r² + d²). The pit of cells has the circle's area.
  const double cell = 0.1, radius = 1.5, depth = 1.0;
  makePass(cell, {.cellTexels = 4, .sampling = {4, 16}});
  int carvedCells = 0;
  carve(cell, depth, [&](double x, double y) {
    const bool inside = std::hypot(x, y) < radius;
    carvedCells += inside;
    return inside;
  });
  pass_.run();
  const std::vector<Received> received = pass_.readReceived();
  const double area = carvedCells * cell * cell / std::numbers::pi;  // effective r²
  EXPECT_NEAR(received[kCells / 2 * kCells + kCells / 2].sky, area / (area + depth * depth), 0.005);
}

TEST_F(LuminancePassTest, TheCheapSettingAgreesWithTheFineOneAndBetterThanAllTexelsWithFourSlices) {
  const double cell = 0.24;
  std::vector<std::vector<float>> means;
  for (const LuminanceSampling sampling : {LuminanceSampling{4, 48}, LuminanceSampling{}, LuminanceSampling{4, 4}}) {
    makePass(cell, {.cellTexels = 4, .sampling = sampling});
    carve(cell, 0.6,
          [](double x, double y) { return static_cast<int>(std::floor(x / 0.72) + std::floor(y / 1.2)) % 2 == 0; });
    pass_.run();
    means.push_back(pass_.readLuminance());
  }
  const auto errors = [&](const std::vector<float>& luminance) {
    double worst = 0, sum = 0;
    for (std::size_t i = 0; i < luminance.size(); ++i) {
      worst = std::max<double>(worst, std::abs(luminance[i] - means[0][i]));
      sum += std::abs(luminance[i] - means[0][i]);
    }
    return std::pair(worst, sum / static_cast<double>(luminance.size()));
  };
  const auto [worst, mean] = errors(means[1]);
  EXPECT_LT(worst, 0.03);
  EXPECT_LT(mean, 0.004);
  EXPECT_LT(worst, errors(means[2]).first);
  EXPECT_LT(mean, errors(means[2]).second);
}

TEST_F(LuminancePassTest, AnUncarvedPlaneUnderLampsHasUnitBrightness) {
  makePass(0.25, {.lights = {{.azimuthDeg = 30, .elevationDeg = 20, .strength = 3}, {.elevationDeg = 90}}});
  pass_.run();
  for (const Received& r : pass_.readReceived()) ASSERT_NEAR(r.lamps, 3 * std::sin(std::numbers::pi / 9) + 1, 1e-3);
  for (const float l : pass_.readLuminance()) ASSERT_NEAR(l, 1, 1e-3);
}

TEST_F(LuminancePassTest, ALampAcrossATrenchLightsTheFloorOutsideTheRimsShadow) {
  const double cell = 0.25, width = 8 * cell, depth = 0.5, elevation = 40;
  const double sine = std::sin(elevation * std::numbers::pi / 180);
  const double shadow = depth / std::tan(elevation * std::numbers::pi / 180);
  for (const double azimuth : {0.0, 90.0, 180.0, 270.0}) {
    makePass(cell, {.lights = {{.azimuthDeg = azimuth, .elevationDeg = elevation}}});
    carve(cell, depth, [&](double x, double) { return std::abs(x) < width / 2; });
    pass_.run();
    const std::vector<Received> received = pass_.readReceived();
    double sum = 0;
    for (int column = -4; column < 4; ++column)
      sum += received[static_cast<std::size_t>(kCells / 2 * kCells + kCells / 2 + column)].lamps / 8;
    const bool across = azimuth == 0 || azimuth == 180;
    EXPECT_NEAR(sum, sine * (across ? 1 - shadow / width : 1), 0.005) << azimuth;
  }
}

TEST_F(LuminancePassTest, APocketIsAsBrightAsByPathTracing) {
  // The rims lie on the mesh's grid, exactly where the map has them; the walls lean inwards by one grid width.
  const double grid = 0.04, half = 1, depth = 0.6, cell = half / 4;
  const Mesh carved = shapes::plate({40, 40}, 20, 1000, 1000, [&](double x, double y) {
    return std::max(std::abs(x), std::abs(y)) < half - grid / 2 ? -depth : 0.0;
  });
  const RayTree tree(carved);
  const std::vector<DirectionalLight> lamp = {{.azimuthDeg = 20, .elevationDeg = 35, .strength = 0.5}};
  std::vector<study::SeenCell> cells;
  for (int row = -4; row < 4; ++row)
    for (int column = -4; column < 4; ++column) {
      // Leaves out the foot of the walls.
      const Vec2 min(column * cell, row * cell);
      cells.push_back({glm::max(min, Vec2(1.5 * grid - half)), glm::min(min + cell, Vec2(half - 1.5 * grid))});
    }
  for (const bool withLamp : {false, true}) {
    const auto lights = withLamp ? lamp : std::vector<DirectionalLight>{};
    makePass(cell, {.lights = lights});
    carve(cell, depth, [&](double x, double y) { return std::abs(x) < half && std::abs(y) < half; });
    pass_.run();
    const std::vector<float> luminance = pass_.readLuminance();
    const std::vector<Received> received = pass_.readReceived();
    const auto traced = study::traceCells(tree, makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, kFar), cells,
                                          {.paths = 1024, .lights = lights});
    double skyError = 0, error = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto at = (kCells / 2 - 4 + i / 8) * kCells + kCells / 2 - 4 + i % 8;
      skyError += std::abs(received[at].sky - traced[i].visibility.mean) / 64;
      error += std::abs(luminance[at] - traced[i].luminance.mean) / 64;
    }
    EXPECT_LT(skyError, 0.015);
    // Near the walls of such a wide pit, more light is reflected than the floor's visibility predicts: the map is 0.05
    // too dark there.
    EXPECT_LT(error, 0.045) << withLamp;
  }
}

TEST_F(LuminancePassTest, AWallBesideTheMapDimsTheCellsThatFaceIt) {
  // A wall of height h at distance x, infinitely long, next to an open plane: V = (1 + x / √(x² + h²)) / 2.
  const double wallHeight = 10, distance = 12;
  const Mesh scene = shapes::together(shapes::translated(shapes::box({400, 400, 10}), {0, 0, -5}),
                                      shapes::translated(shapes::box({20, 400, wallHeight}), {distance + 10, 0, 5}));
  auto geometry = GeometryPass::create();
  ASSERT_TRUE(geometry.has_value());
  const GpuMesh mesh(scene, vertexNormals(scene));
  const ProjectionFrame frame = makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, kFar);
  const MapWindow window{8, 128};
  auto maps = geometry->render(mesh, frame, window);
  ASSERT_TRUE(maps.has_value());
  const auto around = geometry->render(mesh, frame, {200, 512});
  ASSERT_TRUE(around.has_value());
  auto pass = LuminancePass::create(*maps, &*around, kFar, {.sampling = {4, 8}, .horizonSamples = 32});
  ASSERT_TRUE(pass.has_value());
  pass->run();
  const std::vector<Received> received = pass->readReceived();
  const double expected = (1 + distance / std::hypot(distance, wallHeight)) / 2;
  EXPECT_NEAR(received[16 * 32 + 16].sky, expected, 0.02);
  EXPECT_EQ(received[16 * 32 + 16].pastWalls, 1);
}

TEST_F(LuminancePassTest, ListedCellsAreLitAsAmongAllCells) {
  const double cell = 0.25;
  cells_ = 75;  // not a power of two, because some renderers divide to few bits
  makePass(cell, {});
  const auto pits = [](double x, double y) { return std::abs(x) < 3 && std::abs(y) < 3 && std::sin(3 * x) > 0; };
  carve(cell, 0.6, pits);
  std::vector<std::uint32_t> odd, even;
  for (std::uint32_t i = 0; i < 75 * 75; ++i) (i % 2 ? odd : even).push_back(i);
  std::vector<std::vector<float>> luminances;
  for (const LuminanceSampling sampling : {LuminanceSampling{4, 12}, LuminanceSampling{2, 3}}) {
    pass_.setSampling(sampling);
    pass_.selectCells(odd);
    pass_.run();
    pass_.selectCells(even);
    pass_.run();
    luminances.push_back(pass_.readLuminance());
    makePass(cell, {});
    carve(cell, 0.6, pits);
    pass_.setSampling(sampling);
    pass_.run();
    EXPECT_EQ(pass_.readLuminance(), luminances.back()) << sampling.computedTexels;
  }
  double worst = 0, sum = 0;
  for (std::size_t i = 0; i < luminances[0].size(); ++i) {
    worst = std::max<double>(worst, std::abs(luminances[0][i] - luminances[1][i]));
    sum += std::abs(luminances[0][i] - luminances[1][i]);
  }
  EXPECT_LT(worst, 0.1);
  EXPECT_LT(sum / static_cast<double>(luminances[0].size()), 0.01);
  EXPECT_GT(sum, 0) << "the rough one is no rougher";
}

TEST_F(LuminancePassTest, UnselectedCellsKeepTheirLuminance) {
  const double cell = 0.25;
  makePass(cell, {});
  pass_.run();
  const std::vector<float> before = pass_.readLuminance();
  carve(cell, 2, [](double x, double y) { return std::abs(x) < 1 && std::abs(y) < 1; });
  const std::uint32_t middle = kCells / 2 * kCells + kCells / 2;
  pass_.selectCells(std::vector<std::uint32_t>{middle});
  pass_.run();
  const std::vector<float> after = pass_.readLuminance();
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (i == middle)
      EXPECT_LT(after[i], 0.7f);
    else
      ASSERT_EQ(after[i], before[i]);
  }
}

}  // namespace
}  // namespace qrelief
