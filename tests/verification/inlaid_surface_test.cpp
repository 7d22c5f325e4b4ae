// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/inlaid_surface.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "carving/carving_oracle.h"
#include "mesh/ray_tree.h"
#include "support/shapes.h"
#include "verification/solidity.h"

namespace qrelief {
namespace {

constexpr int kModules = 9;
constexpr double kSymbolMm = 12, kDepthMm = 0.6;

bool isDark(int row, int column) { return (3 * row + 5 * column + row * column) % 7 < 3; }

class InlaidSurfaceTest : public testing::TestWithParam<bool> {
 protected:
  void check(const Mesh& model, const ProjectionFrame& frame) {
    const DepthField field = oracle::fieldOf(
        5 * kModules, kSymbolMm, [](int row, int column) { return isDark(row / 5, column / 5) ? kDepthMm : 0; });
    const auto carved = oracle::carve(model, frame, field, {.inlay = true});
    ASSERT_TRUE(carved) << carved.error().message;
    const bool withInlay = GetParam();
    const Mesh file = oracle::welded(withInlay ? shapes::together(carved->mesh, carved->inlay) : carved->mesh);
    const InlaidSurface surface = inlaidSurface(file, frame, kModules, kSymbolMm, kDepthMm);

    EXPECT_EQ(surface.hasBothBodies, withInlay);
    for (int row = 0; row < kModules; ++row)
      for (int column = 0; column < kModules; ++column)
        EXPECT_EQ(surface.inlaid[static_cast<std::size_t>(row * kModules + column)], isDark(row, column))
            << row << ", " << column;
    const auto solid = checkSolidity(surface.mesh);
    ASSERT_TRUE(solid);
    EXPECT_TRUE(solid->closed() && solid->manifold());
    EXPECT_NEAR(solid->volumeMm3, signedVolume(model), 1e-6 * signedVolume(model));
    const RayTree before(model), after(surface.mesh);
    double farthest = 0;
    for (int k = 0; k < 100 * 100; ++k) {
      const Vec3 ray = frame.rayDirection((Vec2(k % 100, k / 100) / 100.0 - 0.497) * kSymbolMm);
      const auto was = before.firstHit(frame.eye(), ray, 0), is = after.firstHit(frame.eye(), ray, 0);
      ASSERT_TRUE(was && is);
      farthest = std::max(farthest, std::abs(was->distance - is->distance));
    }
    EXPECT_LT(farthest, 2e-5);  // floors are moved along rays that were rounded to 32-bit floats
  }
};

TEST_P(InlaidSurfaceTest, IsTheModelsOwnSurface) {
  check(shapes::plate({30, 30}, 10, 40, 40), makeFrame({0.3, 0.2, 0}, {0.1, -0.1, 1}, {0, 1, 0}, 250));
  check(shapes::bumpySphere(30, 0.5, 2, 5), makeFrame({30, 0, 0}, {1, 0, 0}, {0, 0, 1}, 250));
}

TEST_P(InlaidSurfaceTest, LeavesAModelWithoutPocketsAsItIs) {
  const Mesh model = shapes::box({30, 30, 10});
  const InlaidSurface surface =
      inlaidSurface(model, makeFrame({0, 0, 5}, {0, 0, 1}, {0, 1, 0}, 250), kModules, kSymbolMm, kDepthMm);
  EXPECT_EQ(surface.mesh.positions, model.positions);
  EXPECT_EQ(surface.mesh.triangles, model.triangles);
  EXPECT_FALSE(surface.hasBothBodies);
  EXPECT_EQ(std::count(surface.inlaid.begin(), surface.inlaid.end(), 1), 0);
}

TEST_P(InlaidSurfaceTest, KeepsTheFacesWhereOtherBodiesTouch) {
  // A plate whose upper side has a pocket of one module, on another, beside a third; all with faces back to back.
  const ProjectionFrame frame = makeFrame({0, 0, 5}, {0, 0, 1}, {0, 1, 0}, 250);
  const Mesh box = shapes::box({30, 30, 10});
  const DepthField field = oracle::fieldOf(
      5 * kModules, kSymbolMm, [](int row, int column) { return row / 5 == 4 && column / 5 == 4 ? kDepthMm : 0; });
  const auto carved = oracle::carve(box, frame, field, {.inlay = true});
  ASSERT_TRUE(carved) << carved.error().message;
  const Mesh others = shapes::together(shapes::translated(box, {0, 0, -10}), shapes::translated(box, {30, 0, 0}));
  const Mesh all = shapes::together(carved->mesh, others);
  const InlaidSurface surface =
      inlaidSurface(GetParam() ? shapes::together(all, carved->inlay) : all, frame, kModules, kSymbolMm, kDepthMm);
  EXPECT_EQ(surface.hasBothBodies, GetParam());
  EXPECT_EQ(std::count(surface.inlaid.begin(), surface.inlaid.end(), 1), 1);
  EXPECT_EQ(surface.inlaid.at(4, 4), 1);
  EXPECT_NEAR(signedVolume(surface.mesh), 3 * 9000, 0.01);
}

INSTANTIATE_TEST_SUITE_P(BodyAloneAndWithInlay, InlaidSurfaceTest, testing::Bool());

}  // namespace
}  // namespace qrelief
