// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/placement.h"

#include <array>
#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

#include "base/random.h"
#include "messages/sentences.h"
#include "projection/size.h"
#include "render/gpu_surface.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr int kModules = 29;
constexpr double kOuter = 37.0 / 29;  // with the quiet zone

class PlacementTest : public GlTest {
 protected:
  void SetUp() override {
    auto pass = GeometryPass::create();
    ASSERT_TRUE(pass.has_value());
    pass_ = std::make_shared<const GeometryPass>(std::move(*pass));
  }
  void load(const Mesh& mesh) {
    auto prepared = prepareModel(shapes::soupOf(mesh), {});
    ASSERT_TRUE(prepared.has_value());
    model_ = std::move(*prepared);
    surface_.emplace(pass_, GpuMesh(model_.mesh, model_.normals));
  }
  Result<Placement> place(const PlacementRequest& request) const {
    PlacementSearch search(model_, *surface_, kModules, request);
    for (;;) {
      const Result<bool> done = search.step();
      if (!done) return tl::unexpected(done.error());
      if (*done) return search.placement();
    }
  }
  /// Returns a square plate about the z axis, turned anticlockwise by an angle, with its upper side at z = 0.
  static Mesh turnedPlate(double edge, double angle) {
    Mesh plate = shapes::plate({edge, edge}, 5, 4, 4);
    for (Vec3f& p : plate.positions)
      p = Vec3f(
          Vec3(p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle), p.z));
    return plate;
  }
  static constexpr double kTurn = 20 * std::numbers::pi / 180;
  PreparedModel model_;
  std::shared_ptr<const GeometryPass> pass_;
  std::optional<GpuSurface> surface_;
};

TEST_F(PlacementTest, TheThreeSizesOfATurnedSquareMatchTheirClosedForms) {
  load(turnedPlate(40, kTurn));
  PlacementRequest request;
  request.upHint = {0, 1, 0};
  for (const SizeMode mode : {SizeMode::Free, SizeMode::Oriented, SizeMode::Best}) {
    request.sizeMode = mode;
    const auto placed = place(request);
    ASSERT_TRUE(placed.has_value()) << placed.error().message;
    const double outer = mode == SizeMode::Free       ? 40 / std::numbers::sqrt2
                         : mode == SizeMode::Oriented ? 40 / (std::cos(kTurn) + std::sin(kTurn))
                                                      : 40;
    EXPECT_NEAR(placed->symbolMm, outer / kOuter, 1e-3) << sizeModeName(mode);
    EXPECT_NEAR(placed->guaranteedMm, 40 / std::numbers::sqrt2 / kOuter, 1e-3) << sizeModeName(mode);
    EXPECT_NEAR(placed->rotationDeg, mode == SizeMode::Best ? 20 : 0, 1e-3);
    // The reported frame and silhouette use the turned axes.
    const double upTurn = std::atan2(-placed->frame.up.x, placed->frame.up.y);
    EXPECT_NEAR(upTurn * 180 / std::numbers::pi, placed->rotationDeg, 1e-3);
    EXPECT_GE(orientedSize(placed->patch.silhouette), placed->symbolMm * kOuter * (1 - 1e-9));
  }
}

TEST_F(PlacementTest, TheBestSizeIsNeverSmallerThanTheFreeOne) {
  Mesh slab = shapes::box({60, 24, 8});
  for (const auto& [mesh, centres] :
       {std::pair(shapes::together(slab, shapes::translated(shapes::box({24, 60, 40}), {80, 0, 0})),
                  std::vector<Vec3>{{25, 8, 4}, {28, 0, 3}, {29, 11, 4}, {30, 10, -2}, {80, 28, 19}, {90, 29, 15}}),
        std::pair(shapes::bumpySphere(30, 4, 5, 5),
                  std::vector<Vec3>{{30, 0, 0}, {20, 20, 10}, {0, 25, 20}, {-17, 9, 22}, {5, -28, -9}})}) {
    load(mesh);
    for (const Vec3 centre : centres) {
      PlacementRequest request;
      request.centreMm = centre;
      request.quietZone = false;
      request.sizeMode = SizeMode::Free;
      const auto free = place(request);
      request.sizeMode = SizeMode::Best;
      const auto best = place(request);
      if (!free) continue;
      ASSERT_TRUE(best.has_value()) << best.error().message;
      EXPECT_GE(best->symbolMm, free->symbolMm * (1 - 1e-6)) << centre.x << ' ' << centre.y << ' ' << centre.z;
    }
  }
}

TEST_F(PlacementTest, TheFreeSizeDoesNotDependOnTheRotation) {
  Mesh wedge = shapes::plate({60, 60}, 8, 8, 8);  // its wall gets thinner towards +x
  for (Vec3f& p : wedge.positions)
    if (p.z < -1) p.z = -0.6f - 0.1f * (30 - p.x);
  load(wedge);
  PlacementRequest request;
  request.sizeMode = SizeMode::Free;
  request.pockets = {0.8, 1};
  request.beyondMm = 5;
  const auto straight = place(request);
  ASSERT_TRUE(straight.has_value());
  EXPECT_LT(straight->symbolMm, straight->largestMm) << "walls decide";
  for (const double rotateDeg : {20.0, 45.0, 110.0, -30.0}) {
    request.rotateDeg = rotateDeg;
    const auto turned = place(request);
    ASSERT_TRUE(turned.has_value());
    EXPECT_NEAR(turned->symbolMm, straight->symbolMm, 1e-6) << rotateDeg;
  }
}

TEST_F(PlacementTest, ARequestedTurnIsKept) {
  load(turnedPlate(40, kTurn));
  PlacementRequest request;
  request.upHint = {0, 1, 0};
  request.rotateDeg = 35;
  const auto placed = place(request);
  ASSERT_TRUE(placed.has_value());
  EXPECT_NEAR(placed->rotationDeg, 35, 1e-9);
  request.sizeMode = SizeMode::Oriented;
  EXPECT_NEAR(placed->symbolMm, place(request)->symbolMm, 1e-9);
}

TEST_F(PlacementTest, ACodeThatWouldHardlyGrowStaysUpright) {
  // A square turned by t leaves an upright square 1/(cos t + sin t) of its edge: 0.92 at 5°, 0.88 at 8°.
  for (const auto& [turnDeg, isUpright] : {std::pair(5.0, true), std::pair(8.0, false)}) {
    load(turnedPlate(40, turnDeg * std::numbers::pi / 180));
    PlacementRequest request;
    request.upHint = {0, 1, 0};
    const auto placed = place(request);
    ASSERT_TRUE(placed.has_value());
    EXPECT_NEAR(placed->rotationDeg, isUpright ? 0 : turnDeg, 1e-3);
  }
}

TEST_F(PlacementTest, FromOneDirectionTurnedIsNoSmallerThanUprightAndThatThanAnyWayUp) {
  Random random(46);
  int places = 0, reduced = 0;
  const auto draw = [&](const Mesh& mesh, int count) {
    load(mesh);
    for (const int end = places + count; places < end;) {
      const auto t = static_cast<std::uint32_t>(random.below(mesh.triangles.size()));
      const double u = random.uniform(), v = (1 - u) * random.uniform();
      PlacementRequest request;
      request.centreMm = (1 - u - v) * mesh.corner(t, 0) + u * mesh.corner(t, 1) + v * mesh.corner(t, 2);
      request.direction = triangleNormal(mesh, t);
      request.quietZone = random.uniform(0, 1) < 0.5;
      if (random.uniform(0, 1) < 0.6) request.pockets = {0.8, random.uniform(0.3, 1.2)};
      request.beyondMm = 6;
      std::array<double, 3> sizes{};
      std::vector<double> guarantees;
      for (const SizeMode mode : {SizeMode::Free, SizeMode::Oriented, SizeMode::Best}) {
        request.sizeMode = mode;
        const auto placed = place(request);
        sizes[static_cast<std::size_t>(mode)] = placed ? placed->symbolMm : 0;
        if (!placed) continue;
        if (placed->symbolMm < placed->largestMm * (1 - 1e-9)) ++reduced;
        EXPECT_LE(placed->symbolMm, placed->largestMm * (1 + 1e-9));
        EXPECT_LE(placed->guaranteedMm, placed->symbolMm * (1 + 1e-6));
        guarantees.push_back(placed->guaranteedMm);
      }
      const double best = sizes[static_cast<std::size_t>(SizeMode::Best)];
      const double oriented = sizes[static_cast<std::size_t>(SizeMode::Oriented)];
      const double free = sizes[static_cast<std::size_t>(SizeMode::Free)];
      EXPECT_GE(best, oriented * (1 - 1e-6)) << "triangle " << t;
      EXPECT_GE(oriented, free * (1 - 1e-6)) << "triangle " << t;
      for (const double guaranteed : guarantees) EXPECT_NEAR(guaranteed, guarantees.front(), 1e-9) << "triangle " << t;
      if (free > 0) {  // a size that fits at every rotation fits
        request.sizeMode = SizeMode::Fixed;
        request.sizeMm = free * (1 - 1e-9);
        EXPECT_TRUE(place(request).has_value()) << "triangle " << t;
      }
      if (best > 0) ++places;
    }
  };
  draw(shapes::bumpySphere(30, 4, 5, 4), 150);
  draw(shapes::together(shapes::box({60, 24, 8}), shapes::translated(shapes::box({24, 60, 40}), {80, 0, 0})), 100);
  draw(shapes::together(shapes::box({50, 40, 30}), shapes::insideOut(shapes::box({46, 36, 26}))), 150);
  draw(turnedPlate(40, kTurn), 100);
  EXPECT_GE(reduced, 50) << "walls reduce some sizes";
}

TEST_F(PlacementTest, RefusesASizeThatDoesNotFitAndNamesTheLargestHereAndAtTheBestRotation) {
  load(turnedPlate(40, kTurn));
  PlacementRequest request;
  request.upHint = {0, 1, 0};
  request.sizeMode = SizeMode::Fixed;
  request.sizeMm = 36;
  const auto refused = place(request);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().kind, ErrorKind::NoSolution);
  const std::string& message = sentence(refused.error().message);
  EXPECT_NE(message.find("the largest that fits is 24.4"), std::string::npos) << message;
  EXPECT_NE(message.find("and 22.1 mm at every rotation"), std::string::npos) << message;
  const std::string before = "at this rotation, ";
  ASSERT_NE(message.find(before), std::string::npos) << message;
  EXPECT_NE(message.find(" mm at 20°"), std::string::npos) << message;
  const double bestMm = std::stod(message.substr(message.find(before) + before.size()));
  EXPECT_NEAR(bestMm, 40 / kOuter, 0.1);

  // The size named in the message fits as printed.
  request.sizeMm = std::stod(message.substr(message.find("24.4")));
  EXPECT_NEAR(request.sizeMm, 40 / (std::cos(kTurn) + std::sin(kTurn)) / kOuter, 0.1);
  EXPECT_TRUE(place(request).has_value());
  request.sizeMm = bestMm;
  const auto turnable = place(request);
  ASSERT_FALSE(turnable.has_value());
  EXPECT_NE(hint(turnable.error().message).find("--rotate 20"), std::string::npos) << hint(turnable.error().message);
  request.rotateDeg = 20;
  EXPECT_TRUE(place(request).has_value());
}

TEST_F(PlacementTest, TheFoundSizeLeavesRoomForPocketsInATaperingWall) {
  // The wedge is 5 mm thick on the left, 0.5 mm on the right.
  const auto thickness = [](double x) { return 2.75 - 0.1125 * x; };
  Mesh wedge = shapes::plate({40, 40}, 5, 4, 4);
  for (Vec3f& p : wedge.positions)
    if (p.z < -1) p.z = static_cast<float>(-thickness(static_cast<double>(p.x)));
  load(wedge);
  PlacementRequest request;
  request.sizeMode = SizeMode::Free;
  request.upHint = {0, 1, 0};
  request.direction = Vec3(0, 0, 1);
  request.beyondMm = 3;
  request.pockets = {1.5, 0.33};
  const double free = 40 / std::numbers::sqrt2 / kOuter;
  const auto placed = place(request);
  ASSERT_TRUE(placed.has_value()) << placed.error().message;
  // The limit is at the right finder patterns' edge: thickness(size / 2) = 1.5 + 0.33 · size / 29.
  EXPECT_NEAR(placed->symbolMm, (2.75 - 1.5) / (0.1125 / 2 + 0.33 / kModules), 0.04 * free);
  EXPECT_LT(placed->symbolMm, 0.9 * free);
  EXPECT_DOUBLE_EQ(placed->moduleMm, placed->symbolMm / kModules);
  EXPECT_NEAR(placed->largestMm, free, 1e-3) << "what the silhouette allows";
  EXPECT_EQ(placed->guaranteedMm, placed->symbolMm) << "walls count";

  request.pockets.minWallMm = 0.8;
  EXPECT_NEAR(place(request)->symbolMm, free, 1e-3) << "thick enough all over";
  request.pockets.minWallMm = 6;
  EXPECT_NEAR(place(request)->symbolMm, free, 1e-3) << "no size helps: that nothing can be carved is said later";
  request.pockets.minWallMm = 1.5;
  request.sizeMode = SizeMode::Fixed;
  request.sizeMm = 22;
  EXPECT_DOUBLE_EQ(place(request)->symbolMm, 22) << "asked for";
}

TEST_F(PlacementTest, ThePatchExtendsBeyondTheCodeAsFarAsItsWallsReach) {
  load(shapes::icosphere(60, 5));
  PlacementRequest request;
  request.centreMm = {0, 0, 60};
  request.beyondMm = 4;
  request.quietZone = false;
  for (const SizeMode mode : {SizeMode::Free, SizeMode::Oriented, SizeMode::Best, SizeMode::Fixed}) {
    request.sizeMode = mode;
    request.sizeMm = 30;
    request.maxSizeMm = 35;
    const auto placed = place(request);
    ASSERT_TRUE(placed.has_value()) << placed.error().message;
    EXPECT_GE(placed->patch.radiusMm, placed->symbolMm / std::numbers::sqrt2 + 4) << sizeModeName(mode);
  }
}

TEST_F(PlacementTest, TheSearchRadiusDoesNotChangeTheSize) {
  // From a distance D off its surface, the silhouette of a sphere of radius r appears at D·r/√((D + r)² - r²) on
  // the plane that touches it. Small and large size bounds make the first look reach differently far.
  const double r = 30, d = 250;
  const double silhouette = d * r / std::sqrt((d + r) * (d + r) - r * r);
  load(shapes::icosphere(r, 6));
  PlacementRequest request;
  request.direction = Vec3(0, 0, 1);
  request.centreMm = {0, 0, r};
  request.sizeMode = SizeMode::Free;
  for (const double most : {40.0, 60.0, 500.0}) {
    request.maxSizeMm = most;
    const auto placed = place(request);
    ASSERT_TRUE(placed.has_value()) << placed.error().message;
    EXPECT_NEAR(placed->symbolMm * kOuter, std::min(std::numbers::sqrt2 * silhouette, most * kOuter), 0.2) << most;
  }
}

TEST_F(PlacementTest, TheOptimalDirectionIsNoWorseThanTheDepthBalancedOne) {
  load(shapes::bumpySphere(40, 3, 5, 5));
  for (const Vec3 centre : {Vec3(0, 0, 40), Vec3(25, 20, 25), Vec3(-30, 5, 25)}) {
    PlacementRequest request;
    request.centreMm = centre;
    request.sizeMode = SizeMode::Oriented;
    const auto balanced = place(request);
    request.directionMethod = DirectionMethod::Optimal;
    const auto optimal = place(request);
    ASSERT_TRUE(balanced.has_value() && optimal.has_value());
    DirectionOptions options;
    options.sizeMm = balanced->symbolMm;
    const auto measure = [&](const Placement& placed) {
      return lookFrom(*surface_, makeFrame(placed.frame.centre, placed.frame.normal, request.upHint, 250), options)
          ->measure;
    };
    EXPECT_LE(measure(*optimal), measure(*balanced));
    EXPECT_EQ(optimal->iterations.front().normal, balanced->frame.normal);
  }
}

TEST_F(PlacementTest, TheDirectionOfTheLargestCodeGivesNoSmallerOne) {
  load(shapes::bumpySphere(40, 3, 5, 5));
  int larger = 0;
  for (const SizeMode mode : {SizeMode::Best, SizeMode::Oriented, SizeMode::Free})
    for (const Vec3 centre : {Vec3(0, 0, 40), Vec3(25, 20, 25), Vec3(-30, 5, 25)}) {
      PlacementRequest request;
      request.centreMm = centre;
      request.sizeMode = mode;
      request.maxSizeMm = 200;
      const auto balanced = place(request);
      request.directionMethod = DirectionMethod::Largest;
      const auto largest = place(request);
      ASSERT_TRUE(balanced.has_value() && largest.has_value());
      EXPECT_GE(largest->symbolMm, balanced->symbolMm * (1 - 1e-9));
      larger += largest->symbolMm > 1.01 * balanced->symbolMm;
      EXPECT_GT(glm::dot(largest->frame.normal, balanced->frame.normal), 0.5);
    }
  EXPECT_GE(larger, 5);
}

TEST_F(PlacementTest, TheDirectionOfTheLargestCodeStaysWhereTheSizeIsGivenOrTheLargestAllowed) {
  load(shapes::bumpySphere(40, 3, 5, 5));
  PlacementRequest request;
  request.centreMm = {0, 0, 40};
  for (const double maxMm : {10.0, 200.0}) {
    request.maxSizeMm = maxMm;
    request.sizeMode = maxMm > 100 ? SizeMode::Fixed : SizeMode::Best;
    request.sizeMm = 12;
    request.directionMethod = DirectionMethod::DepthBalanced;
    const auto balanced = place(request);
    request.directionMethod = DirectionMethod::Largest;
    const auto largest = place(request);
    ASSERT_TRUE(balanced.has_value() && largest.has_value());
    EXPECT_EQ(largest->frame, balanced->frame);
  }
}

TEST_F(PlacementTest, RefusesADirectionFromBehindWithTheReason) {
  load(shapes::icosphere(40, 4));
  PlacementRequest request;
  request.centreMm = {0, 0, 40};
  request.direction = Vec3(0.1, 0, -1);
  const auto refused = place(request);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().kind, ErrorKind::NoSolution);
  EXPECT_NE(sentence(refused.error().message).find("faces away"), std::string::npos) << refused.error().message;
}

TEST_F(PlacementTest, ACentreOnASmallSteepFacetIsViewedFromWhereTheCodeFits) {
  // The plate has a step of 2 mm within one strip of 0.5 mm. From the strip's own normal, 76° off, hardly any of the
  // plate is visible.
  load(shapes::plate({60, 60}, 10, 120, 12, [](double x, double) { return x < 0.01 ? 0.0 : 2.0; }));
  PlacementRequest request;
  request.centreMm = {0.25, 1, 1};
  const auto placed = place(request);
  ASSERT_TRUE(placed.has_value()) << placed.error().message;
  EXPECT_GT(placed->frame.normal.z, 0.9);
  EXPECT_GT(placed->symbolMm, 20);
}

TEST_F(PlacementTest, NamesACrossingAtTheCentreInsteadOfAnUnprintableSize) {
  // A column comes through the upper face; the code's centre is a hundredth of a millimetre beside it.
  load(shapes::together(shapes::box({40, 40, 10}), shapes::translated(shapes::box({4, 60, 30}), {10, 0, 0})));
  for (const SizeMode mode : {SizeMode::Fixed, SizeMode::Free, SizeMode::Best}) {
    PlacementRequest request;
    request.centreMm = {7.99, 1, 5};
    request.direction = Vec3(0, 0, 1);
    request.sizeMode = mode;
    request.sizeMm = 20;
    const auto refused = place(request);
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().message.code, "crossing-at-centre") << sentence(refused.error().message);
    EXPECT_EQ(sentence(refused.error().message),
              "No code fits here: triangles of the model cross each other 0.01 mm from the centre, at (8, 1, 5), and "
              "the smallest code needs 5.8 mm");
  }
}

TEST_F(PlacementTest, ACodeBesideAPostKeepsAwayFromThePostAlone) {
  // The centre lies on the diagonal of the large face through which the post comes.
  load(shapes::together(shapes::box({60, 60, 40}), shapes::box({10, 10, 60})));
  PlacementRequest request;
  request.centreMm = {18, 18, 20};
  request.direction = Vec3(0, 0, 1);
  request.upHint = {0, 1, 0};
  request.sizeMode = SizeMode::Oriented;
  const auto placed = place(request);
  ASSERT_TRUE(placed.has_value()) << sentence(placed.error().message);
  EXPECT_NEAR(placed->symbolMm * kOuter, 2 * 12, 1e-6) << "to the face's border; the post is 13 mm away along x and y";
}

TEST_F(PlacementTest, AdviceOnRoomNamesTheCrossingsInTheCode) {
  load(shapes::together(shapes::box({40, 40, 10}), shapes::translated(shapes::box({4, 60, 30}), {10, 0, 0})));
  PlacementRequest request;
  request.direction = Vec3(0, 0, 1);
  request.sizeMode = SizeMode::Fixed;
  const auto adviceAt = [&](Vec3 centre, double sizeMm) {
    request.centreMm = centre;
    request.sizeMm = sizeMm;
    const auto refused = place(request);
    EXPECT_FALSE(refused.has_value());
    return refused ? std::string() : hint(refused.error().message);
  };
  EXPECT_EQ(adviceAt({-2, 1, 5}, 30),
            "Choose a smaller size, or a spot farther from crossing triangles (the nearest at (8, 1, 5)), edges and "
            "overhangs; to remove the crossings, unite the model's parts in a CAD program");
  EXPECT_EQ(adviceAt({-17, 1, 5}, 10), "Choose a smaller size, or a spot farther from edges and overhangs");
  request.sizeMode = SizeMode::Free;
  EXPECT_THAT(adviceAt({3.5, 1, 5}, 0), testing::HasSubstr("unite the model's parts"));
}

TEST_F(PlacementTest, ACentreWhereABodyBeginsIsRefused) {
  // A column stands on the plate, and the centre is on its foot: from everywhere, its silhouette leaves no room.
  load(shapes::together(shapes::box({40, 40, 6}), shapes::translated(shapes::box({8, 20, 20}), {0, 0, 13})));
  for (const SizeMode mode : {SizeMode::Fixed, SizeMode::Free, SizeMode::Oriented, SizeMode::Best}) {
    PlacementRequest request;
    request.centreMm = {4, 1, 3};
    request.sizeMode = mode;
    request.sizeMm = 20;
    const auto refused = place(request);
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().kind, ErrorKind::NoSolution) << sentence(refused.error().message);
  }
}

}  // namespace
}  // namespace qrelief
