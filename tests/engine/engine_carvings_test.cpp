// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/engine.h"
#include "gl/objects.h"
#include "io/read_model.h"
#include "io/write_stl.h"
#include "io/zip_archive.h"
#include "pipeline/verify.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;

class EngineCarvingsTest : public GlTest {
 protected:
  void SetUp() override {
    engine_ = std::make_unique<Engine>();
    engine_->resize(400, 300, 1);
    load();
  }
  void load() {
    engine_->loadModel(writeStl(shapes::box({60, 50, 20})), "box.stl", 1);
    engine_->setCentre(R"({"mm": [0, 0, 10]})");
  }
  /// @returns the carving's number
  int carve(const std::string& text) {
    engine_->configure(R"({"text": ")" + text + R"(", "size": 30})");
    return carveBy("{}");
  }
  int carveBy(const std::string& options) {
    EXPECT_EQ(Json::parse(engine_->startJob("engrave", options))["ok"], true);
    toNextAnswer();
    return engine_->carving();
  }
  /// Runs the engraving until the host must answer, or to its end. @returns the last answer
  Json toNextAnswer() {
    for (;;) {
      const Json progress = Json::parse(engine_->advanceJob("engrave"));
      if (progress["ok"] != true) ADD_FAILURE() << progress;
      if (progress["ok"] != true || progress["done"] == true) return progress;
    }
  }
  static std::string lastChange(const Json& step) {
    const Json change = step["changes"].back();
    return change["setting"].get<std::string>() + "=" + change["value"].get<std::string>();
  }
  std::string reportedText() const { return Json::parse(engine_->report())["text"]; }

  std::unique_ptr<Engine> engine_;
};

TEST_F(EngineCarvingsTest, HasNoCarvingAtFirst) {
  EXPECT_EQ(engine_->carving(), 0);
  EXPECT_FALSE(engine_->useCarving(1));
}

TEST_F(EngineCarvingsTest, ShowsNoPrintBeforeAnythingIsEngraved) {
  EXPECT_EQ(Json::parse(engine_->showPrint({0, 0, 0, 0}, 2))["error"]["code"], "nothing-engraved");
}

TEST_F(EngineCarvingsTest, RestoresThePreviousCarvingBitForBitWithItsReadings) {
  const int first = carve("first");
  engine_->setReadings(R"(["first"])", "a reader");
  const auto firstFile = engine_->exportModel("stl");
  const int second = carve("second");
  const auto secondFile = engine_->exportModel("stl");
  ASSERT_NE(first, second);
  ASSERT_NE(firstFile, secondFile);

  ASSERT_TRUE(engine_->useCarving(first));
  EXPECT_EQ(engine_->carving(), first);
  EXPECT_EQ(reportedText(), "first");
  EXPECT_EQ(Json::parse(engine_->report())["verification"]["decoded"], true);
  EXPECT_EQ(engine_->exportModel("stl"), firstFile);
  ASSERT_TRUE(engine_->useCarving(second));
  EXPECT_EQ(reportedText(), "second");
  EXPECT_EQ(engine_->exportModel("stl"), secondFile);
}

TEST_F(EngineCarvingsTest, CarvesTheSameAgainAfterOtherCodesAndModels) {
  carve("https://example.org/first");
  const auto alone = engine_->exportModel("stl");
  carve("https://example.org/other");
  EXPECT_NE(engine_->exportModel("stl"), alone);
  carve("https://example.org/first");
  EXPECT_EQ(engine_->exportModel("stl"), alone);

  engine_->loadModel(writeStl(shapes::box({60, 50, 20.5})), "another.stl", 1);
  engine_->setCentre(R"({"mm": [0, 0, 10.25]})");
  carve("https://example.org/other");
  load();
  carve("https://example.org/first");
  EXPECT_EQ(engine_->exportModel("stl"), alone);
}

TEST_F(EngineCarvingsTest, DescribesACarvingForTheManifest) {
  EXPECT_EQ(Json::parse(engine_->describeRow(0))["error"]["code"], "nothing-engraved");
  carve("part 7");
  const Json unread = Json::parse(engine_->describeRow(12.4));
  EXPECT_EQ(unread["passed"], false);
  EXPECT_FALSE(unread["failed"].empty());
  engine_->setReadings(Json(std::vector<std::string>(engine_->pictures("reading").size(), "part 7")).dump(),
                       "a reader");
  const Json row = Json::parse(engine_->describeRow(12.4));
  EXPECT_EQ(row["passed"], true) << row;
  EXPECT_TRUE(row["failed"].empty());
  EXPECT_EQ(row["details"]["timingsMs"]["total"], 12);
  EXPECT_EQ(row["details"]["verdict"]["reads"], "good");
  EXPECT_GT(row["details"]["depth"]["meanMm"], 0.1);
}

TEST_F(EngineCarvingsTest, PlacesCarvingsSideBySideOnAPlate) {
  EXPECT_EQ(Json::parse(engine_->addToPlate(0, "none", 2))["error"]["code"], "nothing-engraved");
  EXPECT_TRUE(engine_->exportPlate("plate").empty());
  carve("first");
  engine_->addToPlate(0, "P-1", 2);
  carve("second");
  engine_->addToPlate(1, "P-2", 2);
  const auto bytes = engine_->exportPlate("plate");
  const auto plate = readModel(bytes, "plate.3mf");
  ASSERT_TRUE(plate.has_value());
  ASSERT_EQ(plate->parts.size(), 2u);
  EXPECT_EQ(plate->parts[0].name, "P-1");
  EXPECT_EQ(plate->parts[1].name, "P-2");
  double right = 0;
  for (const Vec3& position : plate->positions) right = std::max(right, position.x);
  EXPECT_NEAR(right, 60 + 5 + 60, 0.01);
  EXPECT_TRUE(engine_->exportPlate("plate").empty());

  engine_->addToPlate(0, "of another model", 1);
  load();
  EXPECT_TRUE(engine_->exportPlate("plate").empty());
}

TEST_F(EngineCarvingsTest, CarvesDeeperAndKeepsTheFirstCarvingUntilADeeperOneDecodes) {
  const int first = carve("plan");
  std::vector<std::string> changes;
  Json step;
  for (;;) {
    engine_->setReadings(R"([""])", "a reader");
    step = toNextAnswer();
    EXPECT_EQ(step["best"], first);
    if (step["needs"] != "texts") break;
    changes.push_back(lastChange(step));
    EXPECT_NE(step["carving"], first);
  }
  EXPECT_EQ(changes, (std::vector<std::string>{"carveFor=design", "preset=robust"}));
  EXPECT_EQ(step["needs"], "print");
  EXPECT_EQ(step["carving"], first);
  EXPECT_EQ(Json::parse(engine_->report())["depth"]["preset"], "balanced");

  carveBy(R"({"fixed": ["carveFor", "preset"], "print": false})");
  engine_->setReadings(R"([""])", "a reader");
  do step = toNextAnswer();  // without a print it tries what is left open
  while (step["needs"] == "texts" && Json::parse(engine_->setReadings(R"([""])", "a reader"))["ok"] == true);
  EXPECT_TRUE(step["needs"].is_null());
  EXPECT_EQ(step["carving"], step["best"]);
}

TEST_F(EngineCarvingsTest, ExportsTheBestCarvingWhileAnotherIsMade) {
  const int first = carve("kept");
  const auto stl = engine_->exportModel("stl"), ply = engine_->exportModel("ply");
  ASSERT_FALSE(ply.empty());
  engine_->setReadings(R"([""])", "a reader");
  engine_->advanceJob("engrave");
  EXPECT_EQ(engine_->exportModel("stl", "any", first), stl);
  EXPECT_EQ(engine_->exportModel("ply", "any", first), ply);
  EXPECT_EQ(engine_->exportFiles("a.stl", first).at(0).bytes, stl);
  EXPECT_TRUE(engine_->exportModel("ply").empty()) << "there is no current one";
  toNextAnswer();
  EXPECT_NE(engine_->exportModel("stl"), stl);
  EXPECT_EQ(engine_->exportModel("stl", "any", first), stl);
  EXPECT_TRUE(engine_->exportModel("stl", "any", first + 100).empty());
}

TEST_F(EngineCarvingsTest, AnAttemptWithASmallerSymbolNeedsNoOtherSettings) {
  engine_->configure(R"({"text": "https://example.org/0123456789012345678901234567890123456789", "size": 30})");
  const Json placed = Json::parse(engine_->placement());  // the attempts may use this placement
  carveBy(R"({"print": false})");
  Json step;
  do {
    engine_->setReadings(R"([""])", "a reader");
    step = toNextAnswer();
    ASSERT_EQ(step["needs"], "texts") << step;
  } while (step["changes"].back()["setting"] != "text");
  const Json report = Json::parse(engine_->report());
  const int modules = report["symbol"]["modules"];
  EXPECT_LT(modules, placed["placement"]["modules"].get<int>());
  EXPECT_NEAR(report["size"]["moduleMm"].get<double>() * modules, report["size"]["symbolMm"].get<double>(), 1e-9);
}

TEST_F(EngineCarvingsTest, ACancelKeepsTheBestCarvingSoFar) {
  const int first = carve("best so far");
  const auto stl = engine_->exportModel("stl");
  engine_->setReadings(R"([""])", "a reader");
  engine_->advanceJob("engrave");
  EXPECT_EQ(engine_->carving(), 0) << "a deeper one is made";
  engine_->cancelJob("engrave");
  EXPECT_EQ(engine_->carving(), first);
  EXPECT_EQ(engine_->exportModel("stl"), stl);
  EXPECT_EQ(Json::parse(engine_->advanceJob("engrave"))["error"]["code"], "not-engraving");
}

TEST_F(EngineCarvingsTest, ForgetsOlderCarvings) {
  const int first = carve("a");
  const int second = carve("b");
  carve("c");
  EXPECT_FALSE(engine_->useCarving(first));
  EXPECT_EQ(reportedText(), "c");
  EXPECT_TRUE(engine_->useCarving(second));
}

TEST_F(EngineCarvingsTest, KeepsThePreviousCarvingAfterACancel) {
  const int first = carve("kept");
  engine_->configure(R"({"text": "cancelled", "size": 30})");
  engine_->startJob("engrave");
  engine_->advanceJob("engrave");
  EXPECT_FALSE(engine_->useCarving(first));  // not while another one runs
  engine_->cancelJob("engrave");
  EXPECT_EQ(engine_->carving(), 0);
  ASSERT_TRUE(engine_->useCarving(first));
  EXPECT_EQ(reportedText(), "kept");
}

TEST_F(EngineCarvingsTest, ForgetsAllCarvingsWithAnotherModel) {
  const int first = carve("a");
  const int second = carve("b");
  load();
  EXPECT_FALSE(engine_->useCarving(first));
  EXPECT_FALSE(engine_->useCarving(second));
  EXPECT_EQ(engine_->carving(), 0);
}

TEST_F(EngineCarvingsTest, TheFrontalTrialPictureIsTheReadersView) {
  EXPECT_TRUE(engine_->readerImageFrom(0, 0).pixels.empty());
  carve("picture");
  const GreyImage straight = engine_->pictures("reader").at(0);
  const GreyImage same = engine_->readerImageFrom(0, 0);
  ASSERT_EQ(same.width, straight.width);
  double difference = 0;
  for (std::size_t i = 0; i < same.pixels.size(); ++i)
    difference += std::abs(int{same.pixels[i]} - int{straight.pixels[i]});
  EXPECT_LT(difference / static_cast<double>(same.pixels.size()),
            2);  // the displayed mesh has other normals at its creases

  const GreyImage aside = engine_->readerImageFrom(45, 0);
  ASSERT_EQ(aside.pixels.size(), same.pixels.size());
  double moved = 0;
  for (std::size_t i = 0; i < same.pixels.size(); ++i) moved += std::abs(int{same.pixels[i]} - int{aside.pixels[i]});
  EXPECT_GT(moved, 3 * difference);
}

TEST_F(EngineCarvingsTest, ExportsCodesInColourForASlicerAndOnlyWhereBothColoursFit) {
  for (const std::string mark : {"inlay", "paint"}) {
    engine_->configure(R"({"text": "a", "size": 30, "mark": ")" + mark + R"("})");
    ASSERT_GT(carveBy("{}"), 0);
    const auto any = engine_->exportModel("3mf-inlay");
    EXPECT_EQ(any, engine_->exportModel("3mf", "any")) << mark;
    EXPECT_TRUE(readModel(any, "carved.3mf").has_value()) << mark;
    const auto prusa = engine_->exportModel("3mf-inlay", "prusa");
    EXPECT_TRUE(readModel(prusa, "carved.3mf").has_value()) << mark;
    EXPECT_NE(prusa, any) << mark;
    EXPECT_TRUE(engine_->exportModel("3mf-inlay", "cura").empty()) << mark;
    EXPECT_TRUE(engine_->exportModel("ply").empty()) << mark;
  }
}

TEST_F(EngineCarvingsTest, FillsThePocketsOfAShadowOnlyInAFileOfTwoColours) {
  carve("a");
  const auto volumeMm3 = [&](const std::string& format) {
    return signedVolume(*meshAsFound(*readModel(engine_->exportModel(format), "carved.3mf"), 1));
  };
  const double carved = volumeMm3("3mf");
  EXPECT_LT(carved, 60 * 50 * 20 - 10);
  EXPECT_NEAR(volumeMm3("3mf-inlay"), 60 * 50 * 20, 0.1);
  EXPECT_EQ(volumeMm3("3mf"), carved);
}

TEST_F(EngineCarvingsTest, ReportsWhatLitTheCode) {
  const std::string renderer = gl::rendererName();
  const auto reported = [&] { return Json::parse(engine_->report())["gl"]; };
  carve("by the faster one");
  EXPECT_EQ(reported()["renderer"], gl::isSoftware(renderer) ? "processor" : renderer);
  EXPECT_EQ(reported()["version"] == "", gl::isSoftware(renderer));
  engine_->timePasses(false);  // only shaders have passes
  carve("by shaders");
  EXPECT_EQ(reported()["renderer"], renderer);
  EXPECT_NE(reported()["version"], "");
}

TEST_F(EngineCarvingsTest, WritesTheMapsOfACarvedCode) {
  EXPECT_TRUE(engine_->exportMaps().empty());
  const int first = carve("maps");
  const std::vector<std::uint8_t> npz = engine_->exportMaps();
  const auto archive = ZipArchive::open(npz);
  ASSERT_TRUE(archive.has_value());
  for (const char* name : {"normal", "height", "luminance", "depth", "pass_depth", "pass_luminance"})
    EXPECT_TRUE(archive->find(std::string(name) + ".npy")) << name;
  const Json report = Json::parse(engine_->report());
  const std::string passes = report["depth"]["iterations"].dump();
  const auto npy = unpacked(*archive->find("pass_depth.npy"), std::uint64_t{1} << 30);
  ASSERT_TRUE(npy.has_value());
  EXPECT_NE(std::string(npy->begin(), npy->end()).find("'shape': (" + passes + ", 105, 105)"), std::string::npos);

  carve("other");
  EXPECT_EQ(engine_->exportMaps(first), npz);
  engine_->configure(R"({"text": "letters", "content": "text", "size": 30})");
  ASSERT_GT(carveBy("{}"), 0);
  EXPECT_TRUE(engine_->exportMaps().empty());
}

TEST_F(EngineCarvingsTest, FilesOfABatchAreThoseThatTheCommandWrites) {
  const auto namesOf = [&](const std::string& name) {
    std::vector<std::string> names;
    for (const NamedFile& file : engine_->exportFiles(name)) names.push_back(file.name);
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(namesOf("a.stl"), Names());
  engine_->configure(R"({"text": "a", "size": 30, "mark": "inlay"})");
  ASSERT_GT(carveBy("{}"), 0);
  EXPECT_EQ(namesOf("a.3mf"), Names({"a.3mf"}));
  EXPECT_EQ(namesOf("a.obj"), Names({"a.obj", "a.mtl"}));
  EXPECT_EQ(namesOf("a.ply"), Names());
  const std::vector<NamedFile> files = engine_->exportFiles("a.stl");
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[1].name, "a-2.stl");
  double volumeMm3 = 0;
  for (const NamedFile& file : files) volumeMm3 += signedVolume(*meshAsFound(*readModel(file.bytes, file.name), 1));
  EXPECT_NEAR(volumeMm3, 60 * 50 * 20, 0.1);
  engine_->configure(R"({"text": "a", "size": 30, "mark": "paint"})");
  ASSERT_GT(carveBy("{}"), 0);
  EXPECT_EQ(namesOf("a.obj"), Names({"a.obj", "a.mtl"}));
  EXPECT_EQ(namesOf("a.stl"), Names());
}

}  // namespace
}  // namespace qrelief
