// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "engine/engine.h"
#include "engine/engine_fixture.h"
#include "io/read_model.h"
#include "io/write_stl.h"
#include "support/gl_test.h"
#include "support/shapes.h"
#include "support/zip_file.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;

using EngineViewTest = EngineFixture;

Vec2 vec2Of(const Json& position) { return {position.at(0), position.at(1)}; }

TEST_F(EngineViewTest, TheTopOfTheCodePointsAlongTheUpAxis) {
  load(shapes::box({60, 60, 20}));
  engine_->show(R"({"upAxis": "y"})");
  engine_->configure(kSettings);
  engine_->setCentre(R"({"mm": [0, 0, 10]})");
  const Json answer = Json::parse(engine_->placement());
  ASSERT_EQ(answer["ok"], true) << answer;
  EXPECT_NEAR(answer["placement"]["up"][1].get<double>(), 1, 1e-6);
}

TEST_F(EngineViewTest, TheTopOfTheCodePointsWhereTheSettingsSay) {
  load(shapes::box({60, 60, 20}));
  engine_->show(R"({"upAxis": "y"})");
  engine_->configure(R"({"text": "A", "size": "free", "up": [-1, 0, 0]})");
  engine_->setCentre(R"({"mm": [0, 0, 10]})");
  const Json answer = Json::parse(engine_->placement());
  ASSERT_EQ(answer["ok"], true) << answer;
  EXPECT_NEAR(answer["placement"]["up"][0].get<double>(), -1, 1e-6);
  EXPECT_NEAR(answer["placement"]["rotationDeg"].get<double>(), 0, 1e-6);
}

TEST_F(EngineViewTest, ShowsLampsInTheDirectionTheyShineFrom) {
  load(shapes::box({60, 60, 20}));
  engine_->configure(R"({"text": "A", "size": "free", "light": [{"azimuthDeg": 0, "elevationDeg": 20},
                                                                {"azimuthDeg": 90, "elevationDeg": 20}]})");
  engine_->setCentre(R"({"mm": [0, 0, 10]})");
  ASSERT_TRUE(Json::parse(engine_->placement())["placement"].is_object());
  engine_->look(R"({"kind": "standard", "name": "top"})");
  engine_->draw();
  const Json lamps = Json::parse(engine_->viewState())["lamps"];
  ASSERT_EQ(lamps.size(), 2u);
  const auto at = [&](int lamp, const char* end, int axis) { return lamps[lamp][end][axis].get<double>(); };
  const auto apart = [&](int lamp, int axis) { return at(lamp, "from", axis) - at(lamp, "to", axis); };
  EXPECT_GT(apart(0, 0), 20);   // to the right of the code
  EXPECT_LT(apart(1, 1), -20);  // above it
  EXPECT_GT(apart(0, 0), apart(1, 0) + 20);
  EXPECT_LT(apart(1, 1), apart(0, 1) - 20);
  engine_->configure(kSettings);
  EXPECT_EQ(Json::parse(engine_->viewState())["lamps"].size(), 0u);
}

TEST_F(EngineViewTest, ALampFollowsThePointerUntilTheSettingsAreGiven) {
  load(shapes::box({60, 60, 20}));
  const std::string settings = R"({"text": "A", "size": "free", "light": [{"azimuthDeg": 0, "elevationDeg": 20},
                                                                         {"azimuthDeg": 90, "elevationDeg": 20}]})";
  engine_->configure(settings);
  expectError(engine_->moveLamp(R"({"lamp": 0, "at": [200, 150]})"), "BadUsage", "no-code-placed");
  engine_->setCentre(R"({"mm": [0, 0, 10]})");
  ASSERT_TRUE(Json::parse(engine_->placement())["placement"].is_object());
  engine_->look(R"({"kind": "standard", "name": "top"})");
  for (bool gliding = true; gliding;) gliding = engine_->draw();
  const auto lamp = [&](int index) { return vec2Of(Json::parse(engine_->viewState())["lamps"][index]["from"]); };
  const Vec2 first = lamp(0), second = lamp(1);
  const Vec2 wanted = lamp(0) + Vec2(-10, 25);
  const Json moved = Json::parse(engine_->moveLamp(Json{{"lamp", 0}, {"at", {wanted.x, wanted.y}}}.dump()))["lamps"];
  EXPECT_LT(glm::distance(lamp(0), wanted), 3) << "whole degrees";
  EXPECT_EQ(lamp(1), second);
  EXPECT_GT(moved[0]["azimuthDeg"], 300);
  EXPECT_EQ(moved[1], (Json{{"azimuthDeg", 90}, {"elevationDeg", 20}, {"strength", 1}}));
  expectError(engine_->moveLamp(R"({"lamp": 2, "at": [200, 150]})"), "BadUsage", "no-code-placed");
  engine_->configure(settings);
  EXPECT_EQ(lamp(0), first);
}

TEST_F(EngineViewTest, ShowsTheLightOfTheLamps) {
  load(shapes::box({60, 60, 20}));
  engine_->setCentre(R"({"mm": [0, 0, 10]})");
  const auto configure = [&](const char* settings) {
    engine_->configure(settings);
    ASSERT_TRUE(Json::parse(engine_->placement())["placement"].is_object());
  };
  const auto redraws = [&] {
    engine_->draw();
    const bool isNew = engine_->viewer()->statistics().samples == 0;
    while (engine_->draw()) continue;
    return isNew;
  };
  configure(R"({"text": "A", "size": "free"})");
  redraws();
  engine_->show(R"({"lampLight": true})");
  EXPECT_FALSE(redraws()) << "there are no lamps";
  configure(R"({"text": "A", "size": "free", "light": [{"azimuthDeg": 0, "elevationDeg": 30}]})");
  EXPECT_TRUE(redraws());
  engine_->moveLamp(R"({"lamp": 0, "at": [200, 150]})");
  EXPECT_TRUE(redraws());
  engine_->show(R"({"lampLight": false})");
  EXPECT_TRUE(redraws());
  engine_->moveLamp(R"({"lamp": 0, "at": [220, 150]})");
  EXPECT_FALSE(redraws());
}

TEST_F(EngineViewTest, ShowsThePlateInThePoseOnThePrinter) {
  engine_->show(R"({"buildPlate": true})");
  EXPECT_TRUE(Json::parse(engine_->viewState())["buildPlate"].is_null()) << "no model";
  load(shapes::box({60, 50, 20}));
  const auto heightMm = [&] { return Json::parse(engine_->viewState())["buildPlate"]["heightMm"].get<double>(); };
  EXPECT_NEAR(heightMm(), 20, 1e-5);
  engine_->configure(R"({"text": "A", "buildUp": [0, 1, 0]})");
  EXPECT_NEAR(heightMm(), 50, 1e-5);
  engine_->configure(R"({"text": "A", "buildUp": "code-up"})");
  EXPECT_TRUE(Json::parse(engine_->viewState())["buildPlate"].is_null()) << "no code";
  engine_->setCentre(R"({"mm": [30, 0, 0]})");
  ASSERT_EQ(Json::parse(engine_->placement())["ok"], true);
  EXPECT_NEAR(heightMm(), 60, 1e-5);
  engine_->configure(kSettings);
  engine_->show(R"({"upAxis": "y"})");
  EXPECT_NEAR(heightMm(), 50, 1e-5) << "as the user sees it";
  engine_->look(R"({"kind": "readerView"})");
  EXPECT_TRUE(Json::parse(engine_->viewState())["buildPlate"].is_null()) << "a phone sees no plate";
  engine_->look(R"({"kind": "fit"})");
  EXPECT_NEAR(heightMm(), 50, 1e-5);
  engine_->show(R"({"buildPlate": false})");
  EXPECT_TRUE(Json::parse(engine_->viewState())["buildPlate"].is_null());
}

TEST_F(EngineViewTest, ShowsHowTheCodeWasPlaced) {
  EXPECT_TRUE(Json::parse(engine_->construction())["construction"].is_null()) << "nothing is placed";
  load(shapes::box({60, 36, 20}));
  engine_->configure(R"({"text": "A"})");
  engine_->setCentre(R"({"mm": [3, 0, 10]})");
  ASSERT_EQ(Json::parse(engine_->placement())["ok"], true);
  const Json construction = Json::parse(engine_->construction())["construction"];
  EXPECT_NEAR(construction["closestMm"].get<double>(), 18, 1e-3) << "to the long sides";
  EXPECT_NEAR(construction["squareMm"].get<double>(), 36, 0.1);
  EXPECT_LT(construction["largestMm"], construction["squareMm"]) << "the quiet zone";
  EXPECT_EQ(construction["eyeMm"], 250);
  EXPECT_EQ(construction["colours"]["plane"], "#1466d6");
  EXPECT_EQ(construction["chosen"], 0) << "a flat surface is seen frontally at once";

  const auto shown = [&] { return Json::parse(engine_->viewState())["construction"]; };
  EXPECT_TRUE(shown().is_null());
  engine_->show(R"({"construction": true})");
  EXPECT_FALSE(shown()["centre"].is_null());
  EXPECT_FALSE(shown()["closest"].is_null());
  EXPECT_EQ(shown()["directions"].size(), construction["variancesMm2"].size());
  engine_->look(R"({"kind": "faceConstruction"})");
  for (bool gliding = true; gliding;) gliding = engine_->draw();
  const Vec2 centre = vec2Of(shown()["centre"]), tip = vec2Of(shown()["directions"][0]);
  EXPECT_NEAR(glm::distance(centre, Vec2(200, 150)), 0, 2) << "in the middle of the view";
  EXPECT_GT(glm::distance(centre, tip), 30) << "an arrow seen from aside";
  engine_->look(R"({"kind": "readerView"})");
  EXPECT_TRUE(shown().is_null()) << "a phone sees none";
  engine_->look(R"({"kind": "fit"})");
  EXPECT_FALSE(shown().is_null());
  engine_->show(R"({"construction": false})");
  EXPECT_TRUE(shown().is_null());
}

TEST_F(EngineViewTest, AFaceOnThePlateIsBelowOnTheScreen) {
  engine_->show(R"({"buildPlate": true})");
  load(shapes::box({60, 50, 20}));
  engine_->configure(R"({"text": "A", "buildUp": [1, 0, 0]})");
  for (bool gliding = true; gliding;) gliding = engine_->draw();
  const Json plate = Json::parse(engine_->viewState())["buildPlate"];
  EXPECT_NEAR(plate["heightMm"].get<double>(), 60, 1e-5);
  EXPECT_GT(plate["foot"][1].get<double>(), plate["top"][1].get<double>() + 20);
  EXPECT_NEAR(plate["foot"][0].get<double>(), plate["top"][0].get<double>(), 20);
}

TEST_F(EngineViewTest, TheHeightOverThePlateStandsAtTheLeft) {
  engine_->show(R"({"buildPlate": true})");
  load(shapes::box({60, 50, 20}));
  engine_->look(R"({"kind": "standard", "name": "front"})");
  for (bool gliding = true; gliding;) gliding = engine_->draw();
  const Json plate = Json::parse(engine_->viewState())["buildPlate"];
  EXPECT_LT(plate["foot"][0].get<double>(), 100);
  EXPECT_NEAR(plate["foot"][0].get<double>(), plate["top"][0].get<double>(), 1);
  EXPECT_GT(plate["foot"][1].get<double>(), plate["top"][1].get<double>() + 20);
}

TEST_F(EngineViewTest, LaysTheFaceUnderThePointerOnThePlate) {
  load(shapes::box({60, 50, 20}));
  const auto buildUpSeenFrom = [&](const char* side) {
    engine_->look(Json{{"kind", "standard"}, {"name", side}}.dump());
    for (bool gliding = true; gliding;) gliding = engine_->draw();
    return Json::parse(engine_->layFace("[200, 150]"))["buildUp"];
  };
  EXPECT_EQ(buildUpSeenFrom("right"), Json({-1.0, 0.0, 0.0}));
  EXPECT_EQ(buildUpSeenFrom("front"), Json({0.0, 1.0, 0.0}));
  EXPECT_EQ(buildUpSeenFrom("top"), Json({0.0, 0.0, -1.0}));
  EXPECT_EQ(buildUpSeenFrom("bottom"), "as-modelled");
  EXPECT_EQ(Json::parse(engine_->layFace("[1, 1]"))["hit"], false);
}

TEST_F(EngineViewTest, DrawsPicturesOfSpotsAndDepthsOfCarvings) {
  load(shapes::box({60, 60, 20}));
  engine_->configure(kSettings);
  EXPECT_EQ(engine_->spotPicture(0, 32, 32).width, 0);
  engine_->startJob("spots");
  while (!Json::parse(engine_->advanceJob("spots"))["done"]) {
  }
  const ColourImage picture = engine_->spotPicture(0, 96, 96);
  ASSERT_EQ(picture.rgba.size(), 4u * 96 * 96);
  const auto [darkest, lightest] = std::minmax_element(picture.rgba.begin(), picture.rgba.end());
  EXPECT_GT(*lightest - *darkest, 100);  // a code

  EXPECT_EQ(Json::parse(engine_->show(R"({"depths": true})"))["topMm"], 0);
  engine_->setCentre(R"({"mm": [0, 0, 10]})");
  engine_->startJob("engrave");
  while (!Json::parse(engine_->advanceJob("engrave"))["done"]) {
  }
  const Json colours = Json::parse(engine_->show(R"({"depths": true})")),
             depth = Json::parse(engine_->report())["depth"];
  const double top = colours["topMm"], most = depth["p95Mm"];
  EXPECT_GE(top, most - 1e-6);
  EXPECT_LT(top, most + 0.1);
  EXPECT_NEAR(colours["deepestMm"].get<double>(), depth["maxMm"].get<double>(), 1e-3);
}

}  // namespace
}  // namespace qrelief
