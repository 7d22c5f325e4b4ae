// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/engine.h"

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/engine_fixture.h"
#include "io/read_model.h"
#include "io/write_stl.h"
#include "support/gl_test.h"
#include "support/shapes.h"
#include "support/zip_file.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;

using EngineTest = EngineFixture;

TEST_F(EngineTest, ReportsTheRendererAndNoProblems) {
  const Json capabilities = Json::parse(engine_->capabilities());
  EXPECT_FALSE(capabilities["renderer"].get<std::string>().empty());
  EXPECT_TRUE(capabilities["problems"].empty());
  EXPECT_EQ(Engine("My GPU").gl().renderer, "My GPU");
}

TEST_F(EngineTest, DescribesTheLoadedModel) {
  const Json answer = load(shapes::box({60, 50, 20}));
  ASSERT_EQ(answer["ok"], true);
  const Json& model = answer["model"];
  EXPECT_EQ(model["triangles"], 12);
  EXPECT_EQ(model["vertices"], 8);
  EXPECT_EQ(model["shells"], 1);
  EXPECT_EQ(model["engravable"], true);
  EXPECT_EQ(model["sizeMm"], Json({60, 50, 20}));
  // The proposed centre lies on the box's surface.
  const Vec3 centre(model["centre"][0], model["centre"][1], model["centre"][2]);
  const Vec3 inBox = glm::abs(centre) / Vec3(30, 25, 10);
  EXPECT_NEAR(std::max({inBox.x, inBox.y, inBox.z}), 1, 1e-6);
}

TEST_F(EngineTest, RefusesABadFileAndKeepsTheOldModel) {
  load(shapes::box({60, 50, 20}));
  const Json refused = Json::parse(engine_->loadModel({1, 2, 3}, "broken.stl", 1));
  EXPECT_EQ(refused["ok"], false);
  EXPECT_EQ(refused["error"]["kind"], "BadInput");
  expectError(engine_->loadModel(writeStl(shapes::box({1, 1, 1})), "model.stl", std::nan("")), "BadUsage",
              "scale-unusable");
  EXPECT_EQ(Json::parse(engine_->setCentre(R"({"mm": [0, 0, 100]})"))["centre"], Json({0, 0, 10}));
}

TEST_F(EngineTest, ShowsAnOpenModelButDoesNotEngraveIt) {
  Mesh open = shapes::box({60, 50, 20});
  open.triangles.resize(10);
  const Json answer = load(open);
  ASSERT_EQ(answer["ok"], true);
  EXPECT_EQ(answer["model"]["engravable"], false);
  const Json& findings = answer["model"]["findings"];
  EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [](const Json& f) { return f["severity"] == "blocking"; }));
  engine_->configure(kSettings);
  EXPECT_EQ(Json::parse(engine_->placement())["ok"], false);
  EXPECT_EQ(Json::parse(engine_->startJob("engrave"))["ok"], false);
}

TEST_F(EngineTest, AScaleOfZeroUsesTheUnitOfTheFile) {
  const auto inches = zip_file::threeMf(
      zip_file::modelPart(zip_file::boxObject(1, 2, 3, 1), "<item objectid=\"1\"/>", "unit=\"inch\""));
  EXPECT_EQ(Json::parse(engine_->loadModel(inches, "a.3mf", 0))["model"]["scaleToMm"], 25.4);
  EXPECT_EQ(Json::parse(engine_->loadModel(inches, "a.3mf", 10))["model"]["scaleToMm"], 10);
  EXPECT_EQ(Json::parse(engine_->loadModel(writeStl(shapes::box({9, 9, 9})), "a.stl", 0))["model"]["scaleToMm"], 1);
}

TEST_F(EngineTest, NamesWhateverIsMissing) {
  expectError(engine_->placement(), "BadUsage", "no-model");
  expectError(engine_->startJob("engrave"), "BadUsage", "no-model");
  expectError(engine_->advanceJob("engrave"), "BadUsage", "not-engraving");
  expectError(engine_->advanceJob("view-trials", R"({"read": true})"), "BadUsage", "nothing-engraved");
  expectError(engine_->report(), "BadUsage", "nothing-engraved");
  EXPECT_TRUE(engine_->exportModel("stl").empty());
  EXPECT_TRUE(engine_->pictures("reader").empty());
  expectError(engine_->configure("{"), "BadUsage", "settings-no-object");
  load(shapes::box({60, 60, 20}));
  EXPECT_EQ(Json::parse(engine_->placement())["error"]["kind"], "BadInput");  // no text
}

TEST_F(EngineTest, EngravesStepByStepAndReportsTheResult) {
  load(shapes::box({60, 60, 20}));
  engine_->configure(kSettings);
  engine_->setCentre(R"({"mm": [0, 0, 10]})");
  ASSERT_EQ(Json::parse(engine_->startJob("engrave"))["ok"], true);
  std::set<std::string> stages;
  double fraction = 0;
  for (bool done = false; !done;) {
    const Json progress = Json::parse(engine_->advanceJob("engrave"));
    ASSERT_EQ(progress["ok"], true) << progress;
    EXPECT_GE(progress["fraction"].get<double>(), fraction);
    fraction = progress["fraction"];
    stages.insert(progress["stage"]["code"].get<std::string>());
    done = progress["done"];
  }
  EXPECT_GE(stages.size(), 4u);
  engine_->setReadings(R"(["https://example.org/qrelief-test"])", "a reader");
  const Json report = Json::parse(engine_->report());
  EXPECT_EQ(report["input"]["file"], "model.stl");
  EXPECT_EQ(report["mesh"]["closed"], true);
  EXPECT_EQ(report["verification"]["decoded"], true);
  EXPECT_EQ(report["verification"]["reader"], "a reader");
  const std::vector<GreyImage> seen = engine_->pictures("reader");
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_EQ(seen[0].pixels.size(), static_cast<std::size_t>(seen[0].width) * seen[0].height);
  const auto stl = engine_->exportModel("stl");
  const auto carved = readModel(stl, "carved.stl");
  ASSERT_TRUE(carved.has_value());
  EXPECT_EQ(carved->triangles.size(), report["mesh"]["triangles"].get<std::size_t>());
  EXPECT_TRUE(engine_->exportModel("gif").empty());
  for (const char* format : {"obj", "ply", "3mf"}) {
    const auto same = readModel(engine_->exportModel(format), std::string("carved.") + format);
    ASSERT_TRUE(same.has_value()) << format << ": " << same.error().message;
    EXPECT_EQ(same->triangles.size(), carved->triangles.size()) << format;
  }

  engine_->setCentre(R"({"at": [200, 150]})");  // a new spot: the result can still be exported
  EXPECT_FALSE(engine_->exportModel("stl").empty());
  ASSERT_EQ(Json::parse(engine_->startJob("engrave"))["ok"], true);  // a new engraving discards it
  EXPECT_TRUE(engine_->exportModel("stl").empty());
}

TEST_F(EngineTest, APreparedEngravingSkipsMeasuringAndGivesTheSameResult) {
  const auto prepare = [&] {
    int steps = 1;
    while (!Json::parse(engine_->advanceJob("preparation"))["done"].get<bool>()) ++steps;
    return steps;
  };
  std::vector<std::string> stages;  // of the last engraving, in their order
  const auto enter = [&](const Json& progress) {
    const std::string stage = progress["stage"]["code"];
    if (stages.empty() || stages.back() != stage) stages.push_back(stage);
  };
  const auto start = [&] {
    stages.clear();
    enter(Json::parse(engine_->startJob("engrave")));
  };
  const auto finish = [&] {
    for (bool isDone = false; !isDone;) {
      const Json progress = Json::parse(engine_->advanceJob("engrave"));
      enter(progress);
      isDone = progress["done"].get<bool>();
    }
    return engine_->exportModel("stl");
  };
  EXPECT_EQ(prepare(), 1) << "no model";
  load(shapes::box({60, 60, 20}));
  engine_->configure(kSettings);
  engine_->setCentre(R"({"mm": [0, 0, 10]})");
  EXPECT_EQ(prepare(), 1) << "not placed yet";
  engine_->placement();
  start();
  EXPECT_EQ(prepare(), 1) << "one is running";
  const auto carved = finish();
  ASSERT_FALSE(carved.empty());
  const std::vector<std::string> unprepared = stages;
  ASSERT_EQ(unprepared.front(), "measuring-surface");

  EXPECT_GT(prepare(), 1);
  EXPECT_EQ(prepare(), 1) << "done already";
  EXPECT_EQ(engine_->exportModel("stl"), carved) << "preparing must keep the result";
  start();
  EXPECT_EQ(finish(), carved);
  ASSERT_LT(stages.size(), unprepared.size()) << "the surface is measured already";
  EXPECT_EQ(stages, std::vector(unprepared.end() - std::ssize(stages), unprepared.end()));

  EXPECT_GT(prepare(), 1);
  Json deeper = Json::parse(kSettings);
  deeper["contrast"] = 0.4;
  engine_->configure(deeper.dump());
  engine_->placement();
  start();
  EXPECT_NE(finish(), carved);
  EXPECT_EQ(stages.front(), "measuring-surface") << "another depth was prepared";
}

TEST_F(EngineTest, APreparedEngravingInColourGivesAResult) {
  load(shapes::box({60, 60, 20}));
  engine_->setCentre(R"({"mm": [0, 0, 10]})");
  for (const char* mark : {"inlay", "paint"}) {
    Json settings = Json::parse(kSettings);
    settings["mark"] = mark;
    engine_->configure(settings.dump());
    engine_->placement();
    while (!Json::parse(engine_->advanceJob("preparation"))["done"].get<bool>()) continue;
    engine_->startJob("engrave");
    Json progress;
    do progress = Json::parse(engine_->advanceJob("engrave"));
    while (!progress["done"].get<bool>());
    EXPECT_FALSE(engine_->exportModel("3mf-inlay").empty()) << mark;
  }
}

TEST_F(EngineTest, CanStartAgainAfterACancel) {
  load(shapes::box({60, 60, 20}));
  engine_->configure(kSettings);
  engine_->setCentre(R"({"mm": [0, 0, 10]})");
  engine_->startJob("engrave");
  engine_->advanceJob("engrave");
  engine_->cancelJob("engrave");
  expectError(engine_->advanceJob("engrave"), "BadUsage", "not-engraving");
  EXPECT_EQ(Json::parse(engine_->startJob("engrave"))["ok"], true);
}

TEST_F(EngineTest, AnswersWithValidJsonForTextsThatAreNotUtf8) {
  const Json answer = Json::parse(engine_->loadModel({'x'}, "broken\xff.stl", 1));
  EXPECT_EQ(answer["ok"], false);
}

TEST_F(EngineTest, FindsSpotsOfThePromisedSize) {
  ASSERT_EQ(load(shapes::box({60, 50, 20}))["ok"], true);
  ASSERT_EQ(Json::parse(engine_->configure(kSettings))["ok"], true);
  expectError(engine_->setCentre(R"({"spot": 0})"), "BadUsage", "no-such-spot");
  ASSERT_EQ(Json::parse(engine_->startJob("spots"))["ok"], true);
  Json progress;
  for (bool done = false; !done; done = progress["done"]) {
    EXPECT_FALSE(progress.contains("spots"));
    progress = Json::parse(engine_->advanceJob("spots"));
    ASSERT_EQ(progress["ok"], true) << progress;
  }
  ASSERT_FALSE(progress["spots"].empty());
  EXPECT_TRUE(progress["spots"][0]["concerns"].empty());
  EXPECT_EQ(progress["spots"].back()["concerns"][0]["code"], "spot-too-small-to-print") << "on a side";
  double largestMm = 0;
  for (const Json& spot : progress["spots"]) largestMm = std::max(largestMm, spot["sizeMm"].get<double>());
  EXPECT_NEAR(progress["topMm"].get<double>(), largestMm, 0.1 * largestMm);
  EXPECT_GE(progress["topMm"].get<double>(), largestMm) << "the legend of the sizes";
  for (std::size_t i = 0; i < progress["spots"].size(); ++i) {
    const Json chosen = Json::parse(engine_->setCentre(Json{{"spot", i}}.dump()));
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(chosen["centre"][k], progress["spots"][i]["centre"][k], 1e-9);
    const Json placement = Json::parse(engine_->placement());
    ASSERT_EQ(placement["ok"], true) << placement;
    EXPECT_NEAR(placement["placement"]["symbolMm"], progress["spots"][i]["sizeMm"], 1e-6);
    EXPECT_NEAR(placement["placement"]["largestMm"], progress["spots"][i]["sizeMm"], 1e-6) << "its walls are thick";
  }
  expectError(engine_->setCentre(R"({"spot": 100})"), "BadUsage", "no-such-spot");
  EXPECT_EQ(Json::parse(engine_->setCentre(R"({"spot": 100})"))["error"]["values"]["index"]["index"], 100);
}

TEST_F(EngineTest, TellsTheFixedSizeThatTheMapShowsTheRoomFor) {
  load(shapes::box({60, 50, 20}));
  for (const char* size : {"25", "\"best\""}) {
    engine_->configure(R"({"text": "https://example.org", "size": )" + std::string(size) + "}");
    engine_->startJob("spots");
    Json progress;
    for (bool done = false; !done; done = progress["done"]) progress = Json::parse(engine_->advanceJob("spots"));
    EXPECT_EQ(progress["fixedMm"], std::string(size) == "25" ? Json(25.0) : Json());
    EXPECT_EQ(Json::parse(engine_->show(R"({"sizes": true})"))["ok"], true);
  }
}

TEST_F(EngineTest, HasNoSpotsAfterACancelledSearch) {
  expectError(engine_->startJob("spots"), "BadUsage", "no-model");
  ASSERT_EQ(load(shapes::icosphere(40, 4))["ok"], true);
  ASSERT_EQ(Json::parse(engine_->configure(kSettings))["ok"], true);
  ASSERT_EQ(Json::parse(engine_->startJob("spots"))["ok"], true);
  ASSERT_EQ(Json::parse(engine_->advanceJob("spots"))["ok"], true);
  engine_->cancelJob("spots");
  expectError(engine_->advanceJob("spots"), "BadUsage", "not-finding-spots");
  expectError(engine_->setCentre(R"({"spot": 0})"), "BadUsage", "no-such-spot");
}

TEST_F(EngineTest, ShowsTheDepthSearchWhileItRuns) {
  load(shapes::box({60, 60, 20}));
  engine_->configure(kSettings);
  engine_->setCentre(R"({"mm": [0, 0, 10]})");
  engine_->startJob("engrave");
  EXPECT_FALSE(engine_->jobMap("search-depths").has_value());
  double deepest = 0, darkest = 1;
  for (bool done = false; !done;) {
    done = Json::parse(engine_->advanceJob("engrave"))["done"];
    const auto depths = engine_->jobMap("search-depths"), light = engine_->jobMap("search-luminance");
    ASSERT_EQ(depths.has_value(), light.has_value());
    if (!depths) continue;
    EXPECT_EQ(light->width, depths->width + 2 * kQuietZoneModules * kSubmodulesPerModule);
    EXPECT_EQ(depths->values.size(), static_cast<std::size_t>(depths->width * depths->height));
    deepest = std::max<double>(deepest, *std::max_element(depths->values.begin(), depths->values.end()));
    darkest = std::min<double>(darkest, *std::min_element(light->values.begin(), light->values.end()));
    // Rows begin at the bottom. The corner without a finder pattern is at the symbol's lower right.
    EXPECT_GT(depths->values[static_cast<std::size_t>(depths->width) * 2 + 2], 0);
  }
  EXPECT_GT(deepest, 0.2);
  EXPECT_LT(darkest, 0.8);
}

}  // namespace
}  // namespace qrelief
