// SPDX-License-Identifier: GPL-3.0-or-later
#include "light/height_light.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>

#include "light/height_maps.h"
#include "math/angle.h"
#include "mesh/ray_tree.h"
#include "study/path_tracer.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr double kFar = 20000;  // far enough to make the rays to the eye parallel
constexpr int kSize = 48;

HeightMap plane(int size, double patchMm) { return planeMap(size, patchMm, kFar); }

/// Returns a depth map that is `depthMm` deep where a patch's middle, mm from the map's middle, lies in the area `in`.
std::vector<float> depthsOf(int size, double patchMm, double depthMm, const std::function<bool(double, double)>& in) {
  std::vector<float> depths;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column)
      depths.push_back(in((column + 0.5 - size / 2.0) * patchMm, (row + 0.5 - size / 2.0) * patchMm)
                           ? static_cast<float>(depthMm)
                           : 0.0f);
  return depths;
}

std::vector<Received> measured(const HeightLight& light, const LightOptions& options) {
  std::vector<Received> received;
  light.measure(options, {}, received);
  return received;
}

/// Returns the map of a plane through the frame's centre that is tilted by `tilt`.
HeightMap tiltedPlane(double tilt, double eyeDistance) {
  const int size = 64;
  const double patchMm = 0.6;
  const Vec3 normal(-std::sin(tilt), 0, std::cos(tilt));
  std::vector<float> surface;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const Vec3 ray((column + 0.5 - size / 2.0) * patchMm, (row + 0.5 - size / 2.0) * patchMm, -eyeDistance);
      const double share = -eyeDistance * normal.z / glm::dot(normal, ray);
      for (const double value : {normal.x, normal.y, normal.z, eyeDistance + ray.z * share})
        surface.push_back(static_cast<float>(value));
    }
  return heightMapOf(surface, size, patchMm, eyeDistance);
}

TEST(HeightLight, APlaneSeesTheWholeSky) {
  for (const Received& r : measured(HeightLight(plane(kSize, 0.25)), {})) {
    ASSERT_NEAR(r.sky, 1, 1e-4);
    ASSERT_NEAR(luminanceOf(r, 0.7f, 1), 1, 2e-4);
  }
}

TEST(HeightLight, ATiltedPlaneSeenInPerspectiveSeesTheWholeSky) {
  for (const double tilt : {0.0, 0.2, 0.5, 0.9})
    for (const Received& r : measured(HeightLight(tiltedPlane(tilt, 250)), {.sampling = {1, 16}, .reachMm = 50}))
      ASSERT_NEAR(r.sky, 1, 0.002) << "tilt " << tilt;
}

TEST(HeightLight, ATrenchFloorMatchesTheClosedForm) {
  // At x in an infinite trench between walls at ±w/2, V = (sin(atan((w/2 + x)/d)) + sin(atan((w/2 - x)/d))) / 2. Its
  // integral over x is a difference of √(u² + d²).
  const double patch = 0.25, width = 8 * patch, depth = 1;
  HeightLight light(plane(kSize, patch));
  light.carve(depthsOf(kSize, patch, depth, [&](double x, double) { return std::abs(x) < width / 2; }));
  const auto integral = [&](double x) {
    return (std::hypot(width / 2 + x, depth) - std::hypot(width / 2 - x, depth)) / 2;
  };
  const std::vector<Received> received = measured(light, {.sampling = {4, 32}, .reachMm = 1000});
  for (int column = -4; column < 4; ++column)
    EXPECT_NEAR(received[static_cast<std::size_t>(kSize / 2 * kSize + kSize / 2 + column)].sky,
                (integral((column + 1) * patch) - integral(column * patch)) / patch, 0.004)
        << column;
}

TEST(HeightLight, ACircularPitFloorMatchesTheClosedForm) {
  // The middle of a pit of radius r and depth d has V = r² / (r² + d²). The pit of patches has the circle's area.
  const double patch = 0.1, radius = 1.5, depth = 1.0;
  int carved = 0;
  HeightLight light(plane(kSize, patch));
  light.carve(depthsOf(kSize, patch, depth, [&](double x, double y) {
    const bool inside = std::hypot(x, y) < radius;
    carved += inside;
    return inside;
  }));
  const double area = carved * patch * patch / std::numbers::pi;  // effective r²
  EXPECT_NEAR(measured(light, {.sampling = {4, 32}})[kSize / 2 * kSize + kSize / 2].sky, area / (area + depth * depth),
              0.004);
}

TEST(HeightLight, TheCheapSettingAgreesWithTheFineOne) {
  const double patch = 0.24;
  std::vector<std::vector<Received>> received;
  for (const LightSampling sampling : {LightSampling{4, 64}, LightSampling{}}) {
    HeightLight light(plane(kSize, patch));
    light.carve(depthsOf(kSize, patch, 0.6, [](double x, double y) {
      return static_cast<int>(std::floor(x / 0.72) + std::floor(y / 1.2)) % 2 == 0;
    }));
    received.push_back(
        measured(light, {.sampling = sampling, .everyPatchMm = sampling.points == 4 ? 1e6 : 12 * patch}));
  }
  double worst = 0, sum = 0;
  for (std::size_t i = 0; i < received[0].size(); ++i) {
    const double error = std::abs(static_cast<double>(received[0][i].sky - received[1][i].sky));
    worst = std::max(worst, error);
    sum += error;
  }
  EXPECT_LT(worst, 0.03);
  EXPECT_LT(sum / static_cast<double>(received[0].size()), 0.004);
}

TEST(HeightLight, APlaneUnderLampsHasUnitBrightness) {
  const std::vector<DirectionalLight> lamps = {{.azimuthDeg = 30, .elevationDeg = 20, .strength = 3},
                                               {.elevationDeg = 90}};
  for (const Received& r : measured(HeightLight(plane(kSize, 0.25)), {.lamps = lamps})) {
    ASSERT_NEAR(r.lamps, 3 * std::sin(toRadians(20)) + 1, 1e-3);
    ASSERT_NEAR(luminanceOf(r, 0.7f, static_cast<float>(openIrradiance(lamps))), 1, 1e-3);
  }
}

TEST(HeightLight, ALampAcrossATrenchLightsTheFloorOutsideTheRimsShadow) {
  const double patch = 0.25, width = 8 * patch, depth = 0.5, elevation = 40;
  const double sine = std::sin(toRadians(elevation)), shadow = depth / std::tan(toRadians(elevation));
  for (const double azimuth : {0.0, 90.0, 180.0, 270.0}) {
    HeightLight light(plane(kSize, patch));
    light.carve(depthsOf(kSize, patch, depth, [&](double x, double) { return std::abs(x) < width / 2; }));
    const std::vector<Received> received =
        measured(light, {.lamps = {{.azimuthDeg = azimuth, .elevationDeg = elevation}}});
    double sum = 0;
    for (int column = -4; column < 4; ++column)
      sum += static_cast<double>(received[static_cast<std::size_t>(kSize / 2 * kSize + kSize / 2 + column)].lamps) / 8;
    const bool isAcross = azimuth == 0 || azimuth == 180;
    EXPECT_NEAR(sum, sine * (isAcross ? 1 - shadow / width : 1), 0.006) << azimuth;
  }
}

TEST(HeightLight, ALampLightsATiltedPlaneByItsCosine) {
  const double tilt = 0.4;
  const Vec3 normal(-std::sin(tilt), 0, std::cos(tilt));
  for (const DirectionalLight& lamp : {DirectionalLight{.azimuthDeg = 160, .elevationDeg = 50},
                                       DirectionalLight{.azimuthDeg = 10, .elevationDeg = 30}})  // 7° over the plane
    for (const Received& r : measured(HeightLight(tiltedPlane(tilt, 250)), {.sampling = {1, 8}, .lamps = {lamp}}))
      ASSERT_NEAR(r.lamps, glm::dot(normal, towards(lamp)), 1e-3) << lamp.azimuthDeg;
}

TEST(HeightLight, APocketIsAsBrightAsByPathTracing) {
  // The rims lie on the mesh's grid, exactly where the map has them; the walls lean inwards by one grid width.
  const double grid = 0.04, half = 1, depth = 0.6, patch = half / 4;
  const Mesh carved = shapes::plate({40, 40}, 20, 1000, 1000, [&](double x, double y) {
    return std::max(std::abs(x), std::abs(y)) < half - grid / 2 ? -depth : 0.0;
  });
  const RayTree tree(carved);
  std::vector<study::SeenCell> cells;
  for (int row = -4; row < 4; ++row)
    for (int column = -4; column < 4; ++column) {
      const Vec2 min(column * patch, row * patch);  // leaves out the foot of the walls
      cells.push_back({glm::max(min, Vec2(1.5 * grid - half)), glm::min(min + patch, Vec2(half - 1.5 * grid))});
    }
  for (const auto& lamps : {std::vector<DirectionalLight>{},
                            std::vector<DirectionalLight>{{.azimuthDeg = 20, .elevationDeg = 35, .strength = 0.5}}}) {
    HeightLight light(plane(kSize, patch));
    light.carve(
        depthsOf(kSize, patch, depth, [&](double x, double y) { return std::abs(x) < half && std::abs(y) < half; }));
    const std::vector<Received> received = measured(light, {.lamps = lamps});
    const auto traced = study::traceCells(tree, makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, kFar), cells,
                                          {.paths = 1024, .lights = lamps});
    double skyError = 0, error = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Received& r = received[(kSize / 2 - 4 + i / 8) * kSize + kSize / 2 - 4 + i % 8];
      skyError += std::abs(static_cast<double>(r.sky) - traced[i].visibility.mean) / 64;
      error += std::abs(static_cast<double>(luminanceOf(r, 0.7f, static_cast<float>(openIrradiance(lamps)))) -
                        traced[i].luminance.mean) /
               64;
    }
    EXPECT_LT(skyError, 0.015);
    // Near the walls of such a wide pit, more light is reflected than the floor's visibility predicts: the map is 0.05
    // too dark there.
    EXPECT_LT(error, 0.045) << lamps.size();
  }
}

TEST(HeightLight, MeasuresRequestedPatchesAsAmongAllAndKeepsTheOthers) {
  const double patch = 0.25;
  const int size = 75;
  HeightLight light(plane(size, patch));
  light.carve(depthsOf(size, patch, 0.6,
                       [](double x, double y) { return std::abs(x) < 3 && std::abs(y) < 3 && std::sin(3 * x) > 0; }));
  const std::vector<Received> all = measured(light, {});
  std::vector<std::uint8_t> isMeasured(all.size(), 0);
  for (std::size_t i = 0; i < isMeasured.size(); ++i) isMeasured[i] = i % 7 == 3 && i > 20 * size && i < 50 * size;
  const Received untouched{0.5f, 0.25f, 3, 4};
  std::vector<Received> some(all.size(), untouched);
  light.measure({}, isMeasured, some);
  for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(some[i], isMeasured[i] ? all[i] : untouched) << i;
}

TEST(HeightLight, MissingSurfaceHidesNothing) {
  HeightMap map = plane(kSize, 0.25);
  for (int i = 0; i < kSize; ++i) map.height[static_cast<std::size_t>(i * kSize + i)] = HeightMap::kNothing;
  for (const Received& r : measured(HeightLight(map), {})) ASSERT_NEAR(r.sky, 1, 1e-4);
}

TEST(HeightLight, QuartersOfAPatchAcrossAnEdgeAreLitByTheirOwnFacets) {
  const double tilt = toRadians(35), patchMm = 0.5;
  const auto ridge = [&](int size, double edgeMm) {  // along the middle column
    HeightMap map = planeMap(size, edgeMm, kFar);
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column) {
        const double x = (column + 0.5 - size / 2.0) * edgeMm;
        const auto at = static_cast<std::size_t>(row * size + column);
        map.height[at] = static_cast<float>(-std::abs(x) * std::tan(tilt));
        map.slopeX[at] = x == 0 ? 0 : static_cast<float>(x < 0 ? std::tan(tilt) : -std::tan(tilt));
      }
    return map;
  };
  const int size = 21, middle = size / 2 * size + size / 2;
  const LightOptions options{.lamps = {{.azimuthDeg = 0, .elevationDeg = 30, .strength = 1}}};
  const HeightMap patches = ridge(size, patchMm), quarters = ridge(2 * size, patchMm / 2);
  const double right = std::sin(toRadians(30) + tilt);  // the left facet is turned away from the lamp
  HeightLight light(patches, {}, quarters);
  EXPECT_NEAR(measured(light, options)[middle].lamps, right / 2, 0.01);
  EXPECT_NEAR(measured(HeightLight(patches), options)[middle].lamps, std::sin(toRadians(30)), 0.01);

  std::vector<float> depths(patches.height.size(), 0);
  depths[middle] = 1e-3f;  // as good as uncarved
  light.carve(depths);
  EXPECT_NEAR(measured(light, options)[middle].lamps, right / 2, 0.01);
}

TEST(HeightLight, TheLightOfALampOnAPatchDoesNotDependOnTheOtherPatchesMeasured) {
  const int size = 160;
  HeightLight light(planeMap(size, 0.25, 250));
  std::vector<float> depths(static_cast<std::size_t>(size * size), 0);
  for (std::size_t i = 0; i < depths.size(); ++i) depths[i] = i * 7919 % 13 < 5 ? 0.8f : 0.0f;
  light.carve(depths);
  const LightOptions options{
      .sampling = {2, 12}, .reachMm = 10, .lamps = {{.azimuthDeg = 70, .elevationDeg = 25, .strength = 1}}};
  std::vector<Received> all, some;
  light.measure(options, {}, all);
  std::vector<std::uint8_t> mask(depths.size(), 0);
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = i % static_cast<std::size_t>(size) >= 48;
  light.measure(options, mask, some);
  for (std::size_t i = 0; i < mask.size(); ++i) EXPECT_TRUE(!mask[i] || some[i] == all[i]) << i;
}

}  // namespace
}  // namespace qrelief
