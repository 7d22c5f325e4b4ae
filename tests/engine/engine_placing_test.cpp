// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/engine.h"
#include "engine/engine_fixture.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;

using EnginePlacingTest = EngineFixture;

TEST_F(EnginePlacingTest, AClickOnTheModelHitsAndAClickBesideItMisses) {
  load(shapes::icosphere(30, 5));
  const Json hit = Json::parse(engine_->setCentre(R"({"at": [200, 150]})"));
  ASSERT_EQ(hit["hit"], true);
  const Vec3 centre(hit["centre"][0], hit["centre"][1], hit["centre"][2]);
  EXPECT_NEAR(glm::length(centre), 30, 0.05);
  EXPECT_EQ(Json::parse(engine_->setCentre(R"({"at": [2, 2]})")), Json({{"hit", false}}));
  EXPECT_EQ(Json::parse(engine_->setCentre(R"({"mm": [null, 0, 0]})")), Json({{"hit", false}}));
}

TEST_F(EnginePlacingTest, TheFreeSizeOnTopOfABoxMatchesTheClosedForm) {
  load(shapes::box({60, 60, 20}));
  engine_->configure(kSettings);
  engine_->setCentre(R"({"mm": [0, 0, 10]})");
  const Json answer = Json::parse(engine_->placement());
  ASSERT_EQ(answer["ok"], true) << answer;
  const Json& placement = answer["placement"];
  EXPECT_EQ(placement["modules"], 29);
  EXPECT_EQ(placement["version"], 3);
  // Symbol and quiet zone, 37 modules wide, fit a circle of 30 mm radius about the centre.
  EXPECT_NEAR(placement["symbolMm"].get<double>(), std::sqrt(2.0) * 30 * 29 / 37, 0.01);
  EXPECT_NEAR(placement["normal"][2].get<double>(), 1, 1e-6);
  EXPECT_NEAR(placement["moduleMm"].get<double>() * 29, placement["symbolMm"].get<double>(), 1e-9);
}

TEST_F(EnginePlacingTest, TheCodeFollowsThePointerAndIsPlacedExactlyAfterwards) {
  EXPECT_EQ(Json::parse(engine_->hover("[200, 150]"))["hit"], false);  // no model
  load(shapes::icosphere(30, 5));
  engine_->configure(kSettings);
  const Json about = Json::parse(engine_->hover("[200, 150]"));
  ASSERT_EQ(about["hit"], true) << about;
  EXPECT_EQ(about["onCode"], false);
  EXPECT_EQ(about["code"]["exact"], false);
  ASSERT_EQ(Json::parse(engine_->startJob("settling"))["ok"], true);
  Json progress;
  for (bool done = false; !done; done = progress["done"]) {
    progress = Json::parse(engine_->advanceJob("settling"));
    ASSERT_EQ(progress["ok"], true) << progress;
  }
  EXPECT_EQ(progress["code"]["exact"], true);
  EXPECT_EQ(Json::parse(engine_->hover("null"))["hit"], false);
  expectError(engine_->startJob("settling"), "BadUsage", "no-code-placed");
  const double exact = progress["code"]["symbolMm"], estimated = about["code"]["symbolMm"];
  EXPECT_NEAR(estimated / exact, 1, 0.1);  // a texel of the map is 3 % of the sphere's radius wide
  engine_->setCentre(R"({"at": [200, 150]})");
  const Json placed = Json::parse(engine_->placement());
  EXPECT_NEAR(placed["placement"]["symbolMm"], exact, 1e-9);
  EXPECT_EQ(Json::parse(engine_->hover("[200, 150]"))["onCode"], true);
  expectError(engine_->startJob("settling"), "BadUsage", "no-code-placed");
}

TEST_F(EnginePlacingTest, AClickGoesOnFromTheSearchOfTheCodeUnderThePointer) {
  const auto prepare = [&](const char* options) {
    Json answer, rough;
    int steps = 0, shown = 0;
    do {
      answer = Json::parse(engine_->advanceJob("preparation", options));
      ++steps;
      if (!answer["depths"].is_null() && ++shown == 1) rough = answer["depths"];
    } while (!answer["done"].get<bool>());
    answer.update({{"steps", steps}, {"shown", shown}, {"rough", rough}});
    return answer;
  };
  constexpr const char* kHovered = R"({"search": true, "hovered": true})";
  load(shapes::icosphere(30, 5));
  engine_->configure(kSettings);
  EXPECT_TRUE(prepare(kHovered)["depths"].is_null()) << "nothing is hovered";
  engine_->hover("[200, 150]");
  EXPECT_TRUE(prepare(kHovered)["depths"].is_null()) << "it has not settled";
  engine_->startJob("settling");
  while (!Json::parse(engine_->advanceJob("settling"))["done"].get<bool>()) continue;
  const Json hovered = prepare(kHovered);
  EXPECT_GT(hovered["steps"], 1);
  ASSERT_FALSE(hovered["depths"].is_null());
  EXPECT_GT(hovered["depths"]["meanMm"], 0.05);
  EXPECT_GE(hovered["depths"]["maxMm"], hovered["depths"]["meanMm"]);
  EXPECT_EQ(hovered["shown"], 2) << "after the first pass and at the end";
  EXPECT_NE(hovered["rough"], hovered["depths"]);
  EXPECT_NEAR(hovered["rough"]["meanMm"], hovered["depths"]["meanMm"], 0.2 * hovered["depths"]["meanMm"].get<double>());

  engine_->configure(R"({"text": "another text, which needs a larger symbol", "size": "free"})");
  EXPECT_TRUE(prepare(kHovered)["depths"].is_null()) << "it is for another text";
  engine_->configure(kSettings);
  engine_->setCentre(R"({"at": [200, 150]})");
  engine_->hover("null");
  engine_->placement();
  const Json placed = prepare(R"({"search": true})");
  EXPECT_EQ(placed["steps"], 1) << "the click goes on from there";
  EXPECT_EQ(placed["depths"], hovered["depths"]);
  EXPECT_NE(Json::parse(engine_->startJob("engrave"))["stage"]["code"], "measuring-surface");
}

TEST_F(EnginePlacingTest, TheConcernsUnderThePointerAreThoseOfThePlacedCode) {
  const auto concerns = [&] { return Json::parse(engine_->hoverConcerns())["concerns"]; };
  load(shapes::icosphere(30, 5));
  engine_->configure(R"({"text": "a", "size": 8})");
  EXPECT_EQ(concerns(), Json::array()) << "nothing is hovered";
  engine_->hover("[200, 150]");
  EXPECT_EQ(concerns(), Json::array()) << "it has not settled";
  engine_->startJob("settling");
  Json settled;
  do settled = Json::parse(engine_->advanceJob("settling"));
  while (settled["ok"] == true && settled["done"] == false);
  ASSERT_EQ(settled["ok"], true) << settled;
  const Json hovered = concerns();
  ASSERT_EQ(hovered.size(), 1);
  EXPECT_EQ(hovered[0]["code"], "spot-too-small-to-print");
  engine_->setCentre(R"({"at": [200, 150]})");
  engine_->hover("null");
  EXPECT_EQ(Json::parse(engine_->placement())["placement"]["concerns"], hovered);
  engine_->configure(R"({"text": "a", "size": 20})");
  EXPECT_EQ(Json::parse(engine_->placement())["placement"]["concerns"], Json::array());
}

constexpr const char* kLabelled = R"({"text": "A", "size": "free", "label": "No 7", "frame": "rounded"})";

TEST_F(EnginePlacingTest, ALabelTakesTheSameRoomUnderThePointerAsWherePlaced) {
  load(shapes::icosphere(30, 5));
  engine_->configure(kLabelled);
  const Json hovered = Json::parse(engine_->hover("[200, 150]"));
  ASSERT_EQ(hovered["hit"], true) << hovered;
  engine_->setCentre(R"({"at": [200, 150]})");
  const Json placed = Json::parse(engine_->placement());
  ASSERT_EQ(placed["ok"], true) << placed;
  // An estimate; without the label's room it would be half as large again.
  EXPECT_NEAR(hovered["code"]["symbolMm"].get<double>() / placed["placement"]["symbolMm"].get<double>(), 1, 0.1);
}

TEST_F(EnginePlacingTest, ALabelMustFitToo) {
  load(shapes::box({60, 60, 20}));
  engine_->configure(kLabelled);
  engine_->setCentre(R"({"mm": [0, 0, 10]})");
  const Json placed = Json::parse(engine_->placement());
  ASSERT_EQ(placed["ok"], true) << placed;
  // The square with the label fits a circle of 30 mm radius about the centre.
  EXPECT_NEAR(Json::parse(engine_->viewState())["code"]["edgeMm"].get<double>(), std::sqrt(2.0) * 30, 0.5);
  // Turned by 45 degrees, it takes no fifth more.
  const double symbolMm = placed["placement"]["symbolMm"].get<double>();
  const Json larger = Json::parse(engine_->adjustCode(Json{{"rotateDeg", 45}, {"symbolMm", 1.2 * symbolMm}}.dump()));
  EXPECT_NEAR(larger["code"]["symbolMm"].get<double>() / symbolMm, 1, 0.03);
}

TEST_F(EnginePlacingTest, ReportsWhereTheCodeIsOfTheCarvedModelToo) {
  load(shapes::box({60, 60, 20}));
  engine_->configure(R"({"text": "A", "size": 30})");
  engine_->setCentre(R"({"mm": [0, 0, 10]})");
  engine_->placement();
  const Json before = Json::parse(engine_->viewState())["code"];
  engine_->startJob("engrave");
  while (!Json::parse(engine_->advanceJob("engrave"))["done"].get<bool>()) continue;
  engine_->show(R"({"carved": true})");
  EXPECT_EQ(Json::parse(engine_->viewState())["code"], before);
}

TEST_F(EnginePlacingTest, ReportsWhereAPlacedCodeIsAndTurnsAndResizesIt) {
  const auto resize = [&](double rotateDeg, double symbolMm) {
    return engine_->adjustCode(Json{{"rotateDeg", rotateDeg}, {"symbolMm", symbolMm}}.dump());
  };
  load(shapes::box({60, 60, 20}));
  expectError(resize(0, 20), "BadUsage", "no-code-placed");
  EXPECT_TRUE(Json::parse(engine_->viewState())["code"].is_null());
  engine_->configure(kSettings);
  engine_->setCentre(R"({"mm": [0, 0, 10]})");
  const double mm = Json::parse(engine_->placement())["placement"]["symbolMm"];
  engine_->look(R"({"kind": "standard", "name": "top"})");
  engine_->draw();
  const Json state = Json::parse(engine_->viewState());
  const Json& code = state["code"];
  ASSERT_FALSE(code.is_null());
  EXPECT_NEAR(code["symbolMm"], mm, 1e-9);
  EXPECT_EQ(code["corners"].size(), 4u);
  EXPECT_LT(code["corners"][0][1].get<double>(), code["corners"][3][1].get<double>());  // its top edge is above

  const Json turned = Json::parse(resize(45, mm));
  ASSERT_EQ(turned["ok"], true) << turned;
  EXPECT_LT(turned["code"]["missingShare"], 0.01);  // a free size fits at every rotation
  EXPECT_EQ(Json::parse(engine_->viewState())["code"]["rotationDeg"], 45);
  const Json larger = Json::parse(resize(0, 1.3 * mm));
  EXPECT_NEAR(larger["code"]["symbolMm"], 1.3 * mm, 1e-9);
  const Json limited = Json::parse(resize(45, 1.3 * mm));
  EXPECT_NEAR(limited["code"]["symbolMm"], mm, 0.03 * mm) << "no larger fits at this rotation";
  EXPECT_LT(limited["code"]["missingShare"], 0.01);
  expectError(resize(0, 0), "BadUsage", "code-size-unusable");

  ASSERT_EQ(Json::parse(engine_->adjustCode(R"({"at": [200, 150]})"))["hit"], true);
  EXPECT_EQ(Json::parse(engine_->placement())["placement"]["rotationDeg"], 0);  // the setting applies
}

TEST_F(EnginePlacingTest, ACodePickedNextToAnEdgeMovesOntoTheFaceUnlessItMustBeExact) {
  load(shapes::box({60, 60, 20}));
  engine_->configure(R"({"text": "A"})");
  engine_->look(R"({"kind": "standard", "name": "top"})");
  engine_->draw();
  // A point on the upper face next to its edge, found by moving towards the right.
  Json last;
  double x = 100;
  const auto pick = [&](double at, bool exact) {
    return Json::parse(engine_->setCentre(Json{{"at", {at, 150}}, {"exact", exact}}.dump()));
  };
  do last = pick(++x, true);
  while (last["hit"] == true && last["centre"][0] < 28.5);
  ASSERT_EQ(last["hit"], true) << last;
  ASSERT_LT(last["centre"][0], 30) << last;
  EXPECT_EQ(last["movedMm"], 0);
  ASSERT_EQ(Json::parse(engine_->placement())["placement"]["forgiving"], false);
  const Json moved = pick(x, false);
  EXPECT_GT(moved["movedMm"].get<double>(), 3);
  EXPECT_LT(moved["centre"][0].get<double>(), 27);
  const Json placed = Json::parse(engine_->placement())["placement"];
  EXPECT_EQ(placed["forgiving"], true);
  EXPECT_TRUE(placed["concerns"].empty()) << placed;
}

TEST_F(EnginePlacingTest, AThinWallIsAConcernBeforeAnythingIsCarved) {
  load(shapes::box({60, 60, 1}));
  engine_->configure(R"({"text": "A"})");
  engine_->setCentre(R"({"mm": [0, 0, 0.5]})");
  const Json placed = Json::parse(engine_->placement())["placement"];
  ASSERT_EQ(placed["concerns"].size(), 1u) << placed;
  EXPECT_EQ(placed["concerns"][0]["code"], "nothing-can-be-carved");
  engine_->configure(R"({"text": "A", "mark": "paint"})");
  EXPECT_TRUE(Json::parse(engine_->placement())["placement"]["concerns"].empty());
}

TEST_F(EnginePlacingTest, ShowsACodeThatDoesNotFit) {
  load(shapes::box({60, 60, 20}));
  engine_->configure(R"({"text": "https://example.org/qrelief-test", "size": 55})");
  engine_->setCentre(R"({"mm": [0, 0, 10]})");
  EXPECT_EQ(Json::parse(engine_->placement())["ok"], false);
  EXPECT_EQ(Json::parse(engine_->viewState())["code"]["symbolMm"], 55);
}

TEST_F(EnginePlacingTest, ShowsNoCodeOnAModelThatIsTooSmallForAny) {
  load(shapes::box({3, 3, 3}));
  engine_->configure(kSettings);
  engine_->setCentre(R"({"mm": [0, 0, 1.5]})");
  expectError(engine_->placement(), "NoSolution", "model-too-small");
  EXPECT_TRUE(Json::parse(engine_->viewState())["code"].is_null());
  EXPECT_EQ(Json::parse(engine_->hover("[200, 150]"))["hit"], false);
}

}  // namespace
}  // namespace qrelief
