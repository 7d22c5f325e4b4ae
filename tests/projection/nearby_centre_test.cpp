// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/nearby_centre.h"

#include <cmath>
#include <gtest/gtest.h>

#include "base/random.h"
#include "mesh/prepare.h"
#include "pipeline/placement.h"
#include "projection/flatness.h"
#include "render/surface_raster.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr int kModules = 25;
constexpr double kLeastMm = 12;

class NearbyCentreTest : public ::testing::Test {
 protected:
  void load(Mesh mesh) {
    mesh_ = std::move(mesh);
    raster_.emplace(mesh_);
  }
  EstimatedSurface surface() const { return {mesh_, *raster_, boundingBox(mesh_).diagonal()}; }
  SurfacePoint at(Vec3 point) const { return *closestPoint(mesh_, point); }
  NearbyCentre near(Vec3 point) const {
    auto found = nearbyCentre(surface(), at(point), kModules, request_, kLeastMm);
    EXPECT_TRUE(found.has_value());
    return *found;
  }
  double moved(Vec3 point) const { return glm::distance(near(point).centre.position, at(point).position); }
  bool isSteadyAt(Vec3 point) const {
    const auto estimate = estimateCode(surface(), at(point), kModules, request_);
    return estimate && isSteady(*estimate, kModules, request_, kLeastMm);
  }

  Mesh mesh_;
  std::optional<SurfaceRaster> raster_;
  PlacementRequest request_;
};

TEST_F(NearbyCentreTest, ACodePickedNextToAnEdgeMovesOntoTheFace) {
  load(shapes::box({40, 40, 40}));
  for (const double fromEdge : {0.3, 0.8, 2.0, 3.0, 4.5}) {
    for (const Vec3 picked :
         {Vec3(20 - fromEdge, 3, 20), Vec3(4, fromEdge - 20, 20), Vec3(20 - fromEdge, 20 - fromEdge, 20)}) {
      ASSERT_FALSE(isSteadyAt(picked)) << fromEdge << ": the code is folded there";
      const NearbyCentre found = near(picked);
      EXPECT_NEAR(found.centre.position.z, 20, 1e-4) << "on the same face";
      EXPECT_TRUE(isSteady(found.estimate, kModules, request_, kLeastMm));
      EXPECT_GE(aimToleranceDeg(found.estimate.bendMm, found.estimate.symbolMm / kModules), kForgivingTiltDeg);
      EXPECT_LT(glm::distance(found.centre.position, picked), 24);
    }
  }
}

TEST_F(NearbyCentreTest, ACodeThatLiesFlatStaysWhereItWasPicked) {
  load(shapes::box({60, 60, 20}));
  for (const Vec3 picked : {Vec3(0, 0, 10), Vec3(12, -9, 10), Vec3(-15, 15, 10)}) EXPECT_EQ(moved(picked), 0);
  load(shapes::icosphere(60, 5));
  EXPECT_EQ(moved({0, 36, 48}), 0) << "evenly curved, but little";
}

TEST_F(NearbyCentreTest, ACodeStaysWhereNothingInReachIsBetter) {
  load(shapes::icosphere(9, 4));  // as bent everywhere
  EXPECT_EQ(moved({0, 0, 9}), 0);
  load(shapes::box({8, 8, 120}));  // a rod
  EXPECT_EQ(moved({4, 3.5, 0}), 0);
}

TEST_F(NearbyCentreTest, AFixedCodeMovesToWhereItFits) {
  load(shapes::box({50, 50, 50}));
  request_.sizeMode = SizeMode::Fixed;
  request_.sizeMm = 20;
  const double half = request_.sizeMm * roomFactor(kModules, request_) / 2;
  for (const double x : {23.0, 18.0, 14.0}) {
    const NearbyCentre found = near({x, 0, 25});
    EXPECT_LE(std::abs(found.centre.position.x) + half, 25 + 0.6) << "to about a texel";
    EXPECT_LT(glm::distance(found.centre.position, Vec3(x, 0, 25)), x - (25 - half) + 1) << "no farther than it must";
  }
  request_.sizeMm = 45;
  EXPECT_EQ(moved({20, 0, 25}), 0) << "it fits nowhere";
}

TEST_F(NearbyCentreTest, AtRandomPlacesABentCodeIsSaidToBeBentBeforeItIsPlaced) {
  Random random(200);
  int bent = 0, moved = 0, missed = 0;
  const auto waves = [](double x, double y) { return 2 * std::sin(x / 7) * std::cos(y / 9); };
  for (const Mesh& mesh :
       {shapes::box({40, 30, 20}), shapes::cylinder(14, 60, 96), shapes::bumpySphere(30, 5, 5, 4),
        shapes::torus(30, 12, 96, 48), shapes::icosphere(16, 4), shapes::tetrahedron(60),
        shapes::plate({70, 50}, 6, 40, 40, waves),
        shapes::together(shapes::box({60, 60, 4}), shapes::translated(shapes::box({12, 12, 30}), {10, 5, 17.01}))}) {
    load(mesh);
    const auto prepared = prepareModel(shapes::soupOf(mesh), {});
    ASSERT_TRUE(prepared.has_value());
    for (int i = 0; i < 25; ++i) {
      const auto t = static_cast<std::uint32_t>(random.below(mesh.triangles.size()));
      const double u = random.uniform(), v = (1 - u) * random.uniform();
      const SurfacePoint picked = at((1 - u - v) * mesh.corner(t, 0) + u * mesh.corner(t, 1) + v * mesh.corner(t, 2));
      const auto found = nearbyCentre(surface(), picked, kModules, request_, kLeastMm);
      ASSERT_TRUE(found.has_value());
      if (found->centre.position != picked.position) ++moved;
      PlacementRequest request = request_;
      request.centreMm = found->centre.position;
      PlacementSearch search(*prepared, *raster_, kModules, request);
      Result<bool> done = false;
      while (done && !*done) done = search.step();
      if (!done) continue;  // no code fits, which the page says
      const Placement& placed = search.placement();
      const double exactDeg = aimToleranceDeg(placed.bendMm, placed.moduleMm);
      if (exactDeg >= kForgivingTiltDeg) continue;
      ++bent;
      const CodeEstimate& estimate = found->estimate;
      if (aimToleranceDeg(estimate.bendMm, estimate.symbolMm / kModules) > kForgivingTiltDeg + 2) ++missed;
    }
  }
  EXPECT_GE(bent, 10);
  EXPECT_LE(missed, 2) << "whose exact direction differs; it is known once the pointer rests";
  EXPECT_GE(moved, 10);
}

}  // namespace
}  // namespace qrelief
