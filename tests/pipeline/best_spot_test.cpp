// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/best_spot.h"

#include <cmath>
#include <gtest/gtest.h>

#include "messages/sentences.h"
#include "pipeline/engrave.h"
#include "settings/preset.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

/// Returns a model for the processor.
std::shared_ptr<const EngravableModel> modelOf(const Mesh& mesh) {
  auto prepared = prepareModel(shapes::soupOf(mesh), {});
  EXPECT_TRUE(prepared.has_value());
  return EngravableModel::create(std::move(*prepared), nullptr);
}

EngraveRequest requestOf(const char* text) {
  EngraveRequest request;
  request.code.text = text;
  return request;
}

TEST(BestSpot, TakesTheLargestFaceAndTheCodeFitsThere) {
  const auto model = modelOf(shapes::box({24, 24, 8}));
  EngraveRequest request = requestOf("HELLO");
  const auto spot = bestSpot(model, request);
  ASSERT_TRUE(spot.has_value());
  EXPECT_NEAR(std::abs(spot->centreMm.z), 4, 1e-6);
  request.placement = placedAt(*spot, request.placement);
  request.depth.preset = Preset::Shallow;
  const auto engraved = engrave(model, request);
  ASSERT_TRUE(engraved.has_value());
  EXPECT_NEAR(engraved->placement.symbolMm, spot->symbolMm, 1e-6);
  EXPECT_TRUE(engraved->solidity.solid());
}

TEST(BestSpot, RoundsTheCentreInFileUnits) {
  const auto spot = bestSpot(modelOf(shapes::box({24, 24, 8})), requestOf("HELLO"), {.scaleToMm = 25.4});
  ASSERT_TRUE(spot.has_value());
  EXPECT_NEAR(std::abs(spot->centreFileUnits.z) * 25.4, 4, 25.4e-5);
}

TEST(BestSpot, TellsProgressUpToTheEnd) {
  Progress last;
  const auto spot =
      bestSpot(modelOf(shapes::box({24, 24, 8})), requestOf("HELLO"), {.tell = [&](const Progress& progress) {
                 EXPECT_GE(progress.fraction, last.fraction);
                 last = progress;
               }});
  ASSERT_TRUE(spot.has_value());
  EXPECT_TRUE(last.done);
}

TEST(BestSpot, RefusesACodeWithoutText) {
  const auto spot = bestSpot(modelOf(shapes::box({24, 24, 8})), requestOf(""));
  ASSERT_FALSE(spot.has_value());
  EXPECT_EQ(spot.error().message.code, "text-empty");
}

TEST(BestSpot, RefusesACodeThatFitsNowhere) {
  EngraveRequest request = requestOf("HELLO");
  request.placement.sizeMode = SizeMode::Fixed;
  request.placement.sizeMm = 23;
  const auto spot = bestSpot(modelOf(shapes::box({24, 24, 8})), request);
  ASSERT_FALSE(spot.has_value());
  EXPECT_EQ(spot.error().kind, ErrorKind::NoSolution);
  EXPECT_EQ(spot.error().message.code, "no-spot-so-large");
  EXPECT_EQ(hint(spot.error().message), "Choose a smaller size, or scale the model up");
}

TEST(BestSpot, NamesTheCrossingsThatLeaveNoRoom) {
  Mesh mesh = shapes::box({24, 24, 24});
  for (const Vec3 size : {Vec3(1, 1, 26), Vec3(1, 26, 1), Vec3(26, 1, 1)})
    mesh = shapes::together(mesh, shapes::box(size));
  EngraveRequest request = requestOf("HELLO");
  request.placement.sizeMode = SizeMode::Fixed;
  request.placement.sizeMm = 14;
  const auto spot = bestSpot(modelOf(mesh), request);
  ASSERT_FALSE(spot.has_value());
  EXPECT_EQ(spot.error().message.code, "no-spot-so-large");
  EXPECT_NE(hint(spot.error().message).find("triangles that cross each other"), std::string::npos)
      << hint(spot.error().message);
}

TEST(BestSpot, PlacesWithTheSpotsDirectionOnlyIfItNeedsThat) {
  PlacementRequest asked;
  asked.rotateDeg = 30;
  Spot spot;
  spot.centreMm = Vec3(1, 2, 3);
  spot.direction = Vec3(0, 0, 1);
  PlacementRequest wanted = asked;
  wanted.centreMm = spot.centreMm;
  EXPECT_EQ(placedAt(spot, asked), wanted);
  spot.needsDirection = true;
  wanted.direction = spot.direction;
  EXPECT_EQ(placedAt(spot, asked), wanted);
}

}  // namespace
}  // namespace qrelief
