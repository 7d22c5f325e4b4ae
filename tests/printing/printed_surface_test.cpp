// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/printed_surface.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "mesh/ray_tree.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

const PrintProcess kProcess = *processOf({.nozzleMm = 0.4, .layerMm = 0.2});

/// Returns a frame seen straight from above, over (x, y).
ProjectionFrame above(double x, double y, double z) { return makeFrame({x, y, z}, {0, 0, 1}, {0, 1, 0}, 250); }

/// Returns heights over the QR plane, NaN where there is no surface.
std::vector<double> heightsOf(const PrintedSurface& surface) {
  std::vector<double> heights;
  for (int row = 0; row < surface.texels; ++row)
    for (int column = 0; column < surface.texels; ++column) {
      const double distance =
          static_cast<double>(surface.distanceMm[static_cast<std::size_t>(row * surface.texels + column)]);
      const Vec3 at = surface.frame.eye() + surface.frame.rayDirection(surface.planePoint(column, row)) * distance;
      heights.push_back(distance > 0 ? glm::dot(at - surface.frame.centre, surface.frame.normal) : std::nan(""));
    }
  return heights;
}

double heightAt(const PrintedSurface& surface, Vec2 at) {
  const Vec2 place = glm::floor(at / surface.texelMm + surface.texels / 2.0);
  return heightsOf(surface)[static_cast<std::size_t>(place.y) * static_cast<std::size_t>(surface.texels) +
                            static_cast<std::size_t>(place.x)];
}

TEST(PrintedSurface, TheTopIsTheEndOfTheLastLayerWhoseMiddleIsInTheSolid) {
  const struct { double top, printed; } cases[] = {{5, 5}, {5.09, 5}, {5.11, 5.2}, {4.91, 5}, {4.89, 4.8}};
  for (const auto& [top, printed] : cases) {
    const Mesh block = shapes::translated(shapes::box({20, 20, top}), {0, 0, top / 2});
    const auto surface = printSurface(block, {kProcess, above(0, 0, top), 8, {0, 0, 1}});
    ASSERT_TRUE(surface);
    for (const double height : heightsOf(*surface)) EXPECT_NEAR(top + height, printed, 1e-3) << top;
  }
}

TEST(PrintedSurface, AWallHasAGrooveBetweenEveryTwoLayers) {
  const Mesh block = shapes::translated(shapes::box({20, 20, 20}), {0, 0, 10});
  const ProjectionFrame frame = makeFrame({0, -10, 10}, {0, -1, 0}, {0, 0, 1}, 250);
  const auto surface = printSurface(block, {kProcess, frame, 6, {0, 0, 1}});
  ASSERT_TRUE(surface);
  double sum = 0, deepest = 0;
  const std::vector<double> heights = heightsOf(*surface);
  for (const double height : heights) {
    EXPECT_LT(height, 0.002);
    sum -= height;
    deepest = std::max(deepest, -height);
  }
  // Flanks are round, so a groove's mean depth is (1 − π/4) of its deepest point, slightly less where its bottom is
  // filled.
  EXPECT_NEAR(sum / static_cast<double>(heights.size()), kProcess.grooveMm * (1 - std::numbers::pi / 4), 0.0025);
  EXPECT_LE(deepest, kProcess.grooveMm);
  EXPECT_GT(deepest, 0.3 * kProcess.grooveMm);
}

TEST(PrintedSurface, OnASlopeLayersMakeStepsRoundTheDesignedSurface) {
  // The wedge's upper face rises by one in two.
  const Mesh wedge = shapes::plate({40, 40}, 15, 1, 1, [](double x, double) { return x / 2; });
  const Vec3 normal = glm::normalize(Vec3(-1, 0, 2));
  const auto surface = printSurface(wedge, {kProcess, makeFrame({0, 0, 0}, normal, {0, 1, 0}, 250), 8, {0, 0, 1}});
  ASSERT_TRUE(surface);
  double sum = 0, most = 0;
  const std::vector<double> heights = heightsOf(*surface);
  for (const double height : heights) {
    ASSERT_FALSE(std::isnan(height));
    sum += height;
    most = std::max(most, std::abs(height));
  }
  EXPECT_LT(std::abs(sum / static_cast<double>(heights.size())), 0.03);
  EXPECT_LT(most, kProcess.layerMm);
  EXPECT_GT(most, 0.3 * kProcess.layerMm);
}

TEST(PrintedSurface, ARidgeTooThinForTheNozzleIsGoneAndAThickerOneStays) {
  Mesh block = shapes::translated(shapes::box({20, 20, 4}), {0, 0, 2});
  block = shapes::together(block, shapes::translated(shapes::box({0.08, 10, 2}), {-2, 0, 4}));  // 1 mm high
  block = shapes::together(block, shapes::translated(shapes::box({1, 10, 2}), {2, 0, 4}));
  const auto surface = printSurface(block, {kProcess, above(0, 0, 4), 8, {0, 0, 1}});
  ASSERT_TRUE(surface);
  EXPECT_NEAR(heightAt(*surface, {-2, 0}), 0, 1e-3);
  EXPECT_NEAR(heightAt(*surface, {2, 0}), 1, 1e-3);
}

TEST(PrintedSurface, IsIndependentOfTheModelsOrientationInItsFile) {
  const Mesh block =
      shapes::plate({20, 20}, 5, 40, 40, [](double x, double y) { return 0.5 * std::sin(x) * std::cos(1.3 * y); });
  const auto upright = printSurface(block, {kProcess, above(1, 2, 0), 6, {0, 0, 1}});
  Mesh turnedMesh = block;  // x → y → z → x
  for (Vec3f& p : turnedMesh.positions) p = {p.z, p.x, p.y};
  const auto lying =
      printSurface(turnedMesh, {kProcess, makeFrame({0, 1, 2}, {1, 0, 0}, {0, 0, 1}, 250), 6, {1, 0, 0}});
  ASSERT_TRUE(upright && lying);
  const std::vector<double> a = heightsOf(*upright), b = heightsOf(*lying);
  ASSERT_EQ(a.size(), b.size());
  std::size_t apart = 0;  // the grids' nodes lie elsewhere, so rims of layers differ slightly
  for (std::size_t i = 0; i < a.size(); ++i) apart += std::abs(a[i] - b[i]) > 0.02;
  EXPECT_LT(static_cast<double>(apart) / static_cast<double>(a.size()), 0.03);
}

TEST(PrintedSurface, AWiderViewShowsTheSame) {
  // The view determines where a layer's tiles end; the tile borders must not show.
  Mesh block = shapes::translated(shapes::box({60, 60, 10}), {0, 0, 5});
  for (int k = -12; k <= 12; ++k)
    block = shapes::together(block, shapes::translated(shapes::box({0.45, 40, 2}), {1.1 * k + 0.07, 0, 10}));
  const auto narrow = printSurface(block, {kProcess, above(0, 0, 10), 12, {0, 0, 1}});
  const auto wide = printSurface(block, {kProcess, above(0, 0, 10), 17.2, {0, 0, 1}});
  ASSERT_TRUE(narrow && wide);
  ASSERT_NEAR(narrow->texelMm, wide->texelMm, 1e-9);
  const int border = (wide->texels - narrow->texels) / 2;
  const std::vector<double> a = heightsOf(*narrow), b = heightsOf(*wide);
  std::size_t apart = 0;  // nodes lie elsewhere, so rims may differ slightly
  for (int row = 0; row < narrow->texels; ++row)
    for (int column = 0; column < narrow->texels; ++column) {
      const double there = b[static_cast<std::size_t>((row + border) * wide->texels + column + border)];
      apart += std::abs(a[static_cast<std::size_t>(row * narrow->texels + column)] - there) > 0.02;
    }
  EXPECT_LT(static_cast<double>(apart) / static_cast<double>(a.size()), 0.005);
}

TEST(PrintedSurface, ItsMeshPassesThroughItsPointsAndFacesTheEye) {
  const Mesh block = shapes::translated(shapes::box({20, 20, 4}), {0, 0, 2});
  const auto surface = printSurface(block, {kProcess, above(9, 0, 4), 4, {0, 0, 1}});  // the block ends at x = 10
  ASSERT_TRUE(surface);
  const Mesh mesh = surface->mesh();
  const RayTree tree(mesh);
  for (int row = 1; row + 1 < surface->texels; row += 7)
    for (int column = 1; column + 1 < surface->texels; column += 7) {
      const auto hit =
          tree.firstHit(surface->frame.eye(), surface->frame.rayDirection(surface->planePoint(column, row)));
      const double distance =
          static_cast<double>(surface->distanceMm[static_cast<std::size_t>(row * surface->texels + column)]);
      if (hit) {
        EXPECT_NEAR(hit->distance, distance, 1e-3);
      }
      if (surface->planePoint(column, row).x > 1.1) {
        EXPECT_EQ(distance, 0);
      }
    }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    ASSERT_GT(glm::dot(triangleNormal(mesh, t), surface->frame.eye() - mesh.corner(t, 0)), 0);
}

TEST(PrintedSurface, HitsNothingBesideTheModel) {
  const auto surface = printSurface(shapes::box({10, 10, 10}), {kProcess, above(500, 0, 5), 8, {0, 0, 1}});
  ASSERT_TRUE(surface);
  for (const float distance : surface->distanceMm) EXPECT_EQ(distance, 0);
  EXPECT_TRUE(surface->mesh().triangles.empty());
}

TEST(PrintedSurface, SamplesLargeCodesAndFineProcessesMoreCoarsely) {
  const Mesh block = shapes::translated(shapes::box({600, 600, 4}), {0, 0, 2});
  const auto large = printSurface(block, {kProcess, above(0, 0, 4), 500, {0, 0, 1}});
  ASSERT_TRUE(large);
  EXPECT_EQ(large->texels, 1000);
  EXPECT_NEAR(heightAt(*large, {0, 0}), 0, 1e-3);
  const auto fine =
      printSurface(block, {*processOf({.nozzleMm = 0.01, .layerMm = 0.01}), above(0, 0, 4), 40, {0, 0, 1}});
  ASSERT_TRUE(fine);
  EXPECT_EQ(fine->texels, 1000);
  EXPECT_NEAR(heightAt(*fine, {0, 0}), 0, 0.011);
}

TEST(PrintedSurface, RefusesABuildDirectionOfZero) {
  const auto surface = printSurface(shapes::box({10, 10, 10}), {kProcess, above(0, 0, 5), 4, {0, 0, 0}});
  ASSERT_FALSE(surface);
  EXPECT_EQ(surface.error().message.code, "no-build-direction");
}

}  // namespace
}  // namespace qrelief
