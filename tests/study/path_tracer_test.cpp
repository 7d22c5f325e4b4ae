// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/path_tracer.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "mesh/ray_tree.h"
#include "support/shapes.h"

namespace qrelief::study {
namespace {

constexpr double kFar = 20000;

ProjectionFrame fromAbove() { return makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, kFar); }

/// Returns a plate whose upper face lies at z = 0 and drops steeply to -depth where `inPit(x, y)`.
template <class Predicate>
Mesh carvedPlate(double edge, int cells, double depth, Predicate inPit) {
  return shapes::plate({edge, edge}, 20, cells, cells, [&](double x, double y) { return inPit(x, y) ? -depth : 0.0; });
}

TEST(PathTracer, AnOpenPlaneSeesTheWholeSky) {
  const Mesh plate = shapes::box({100, 100, 10});
  const RayTree tree(plate);
  const SeenCell cell{{-5, -5}, {5, 5}};
  const auto light = traceCells(tree, fromAbove(), std::span(&cell, 1), {});
  EXPECT_EQ(light[0].visibility.mean, 1);
  EXPECT_EQ(light[0].luminance.mean, 1);
}

TEST(PathTracer, TheMiddleOfAPitMatchesTheClosedForm) {
  // Between grid points the walls lean by one grid width, so the pit's rim lies at radius + width / 2 on average.
  const double grid = 0.05, radius = 3, depth = 2;
  const Mesh pit = carvedPlate(20, 400, depth, [&](double x, double y) { return std::hypot(x, y) < radius; });
  const RayTree tree(pit);
  const SeenCell cell{{-0.01, -0.01}, {0.01, 0.01}};
  const auto light = traceCells(tree, fromAbove(), std::span(&cell, 1), {.paths = 20000});
  const double rim = radius + grid / 2;
  EXPECT_NEAR(light[0].visibility.mean, rim * rim / (rim * rim + depth * depth), 0.005);
}

TEST(PathTracer, TheMiddleOfATrenchMatchesTheClosedForm) {
  // The trench's rims lie on the grid, at ±width/2; the walls lean inwards by one grid width.
  const double grid = 0.05, width = 2, depth = 1.5;
  const Mesh trench = carvedPlate(20, 400, depth, [&](double x, double) { return std::abs(x) < width / 2 - grid / 2; });
  const RayTree tree(trench);
  const SeenCell cell{{-0.01, -0.5}, {0.01, 0.5}};
  const auto light = traceCells(tree, fromAbove(), std::span(&cell, 1), {.paths = 20000});
  EXPECT_NEAR(light[0].visibility.mean, std::sin(std::atan(width / (2 * depth))), 0.005);
}

TEST(PathTracer, EveryPointInsideASphereWithAHoleIsEquallyBright) {
  // In an integrating sphere without a cap of height h, the sky fills the share f = h / 2r of the cosine-weighted
  // directions from every inside point, and L = f / (1 - albedo·(1 - f)).
  Mesh sphere = shapes::icosphere(10, 5);
  const double rim = 8;
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < sphere.triangles.size(); ++t)
    if (sphere.corner(t, 0).z + sphere.corner(t, 1).z + sphere.corner(t, 2).z < 3 * rim)
      triangles.push_back(sphere.triangles[t]);
  double keptArea = 0, area = 0;
  const auto areaOf = [&](const Triangle& t) {
    const auto at = [&](int k) { return Vec3(sphere.positions[t[static_cast<std::size_t>(k)]]); };
    return glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) / 2;
  };
  for (const Triangle& t : sphere.triangles) area += areaOf(t);
  for (const Triangle& t : triangles) keptArea += areaOf(t);
  sphere.triangles = triangles;
  const double open = 1 - keptArea / area;
  const RayTree tree(sphere);
  const std::vector<SeenCell> cells = {{{-1, -1}, {1, 1}}, {{2, 1}, {3, 2}}};
  for (const double albedo : {0.3, 0.8}) {
    for (const CellLight& light : traceCells(tree, fromAbove(), cells, {.paths = 40000, .albedo = albedo})) {
      EXPECT_NEAR(light.visibility.mean, open, 0.005);
      EXPECT_NEAR(light.luminance.mean, open / (1 - albedo * (1 - open)), 5 * light.luminance.standardError);
    }
  }
}

TEST(PathTracer, AnOpenPlaneUnderALampHasUnitBrightnessByLambertsLaw) {
  const Mesh plate = shapes::box({100, 100, 10});
  const RayTree tree(plate);
  const SeenCell cell{{-5, -5}, {5, 5}};
  const auto light = traceCells(
      tree, fromAbove(), std::span(&cell, 1),
      {.lights = {{.azimuthDeg = 40, .elevationDeg = 30, .strength = 2}, {.azimuthDeg = 200, .elevationDeg = 90}}});
  EXPECT_NEAR(light[0].direct.mean, 2 * 0.5 + 1, 1e-9);
  EXPECT_NEAR(light[0].luminance.mean, 1, 1e-9);
}

TEST(PathTracer, ALampAcrossATrenchLightsTheFloorOutsideTheRimsShadow) {
  // The rim's shadow is depth / tan(elevation) long; the walls lean inwards by one grid width.
  const double grid = 0.05, width = 2, depth = 0.5, elevation = 40;
  const Mesh trench = carvedPlate(20, 400, depth, [&](double x, double) { return std::abs(x) < width / 2 - grid / 2; });
  const RayTree tree(trench);
  const SeenCell floor{{-width / 2 + grid, -0.5}, {width / 2 - grid, 0.5}};
  const auto lit = [&](double azimuth) {
    const DirectionalLight lamp{.azimuthDeg = azimuth, .elevationDeg = elevation, .strength = 1};
    return traceCells(tree, fromAbove(), std::span(&floor, 1), {.paths = 8192, .lights = {lamp}})[0].direct.mean;
  };
  const double sine = std::sin(elevation * std::numbers::pi / 180);
  const double shadow = depth / std::tan(elevation * std::numbers::pi / 180);
  const double share = (width - grid - shadow) / (width - 2 * grid);
  EXPECT_NEAR(lit(0), sine * share, 0.005);
  EXPECT_NEAR(lit(180), sine * share, 0.005);
  EXPECT_NEAR(lit(90), sine, 0.005);
}

TEST(PathTracer, IsDeterministicForASeed) {
  const Mesh pit = carvedPlate(20, 40, 2, [](double x, double y) { return std::hypot(x, y) < 3; });
  const RayTree tree(pit);
  const SeenCell cell{{-1, -1}, {1, 1}};
  const auto once = traceCells(tree, fromAbove(), std::span(&cell, 1), {});
  const auto again = traceCells(tree, fromAbove(), std::span(&cell, 1), {});
  EXPECT_EQ(once[0].luminance.mean, again[0].luminance.mean);
}

}  // namespace
}  // namespace qrelief::study
