// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/printed_code.h"

#include "engine/engine.h"
#include "io/write_stl.h"
#include "native/read_carving.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

class PrintedCodeTest : public GlTest {
 protected:
  void SetUp() override {
    engine_ = std::make_unique<Engine>();
    engine_->resize(400, 300, 1);
    engine_->loadModel(writeStl(shapes::box({60, 50, 20})), "box.stl", 1);
    engine_->setCentre(R"({"mm": [0, 0, 10]})");
  }
  void carve(double sizeMm, const std::string& process, const Json& others = Json::object()) {
    Json settings = {{"text", "QRELIEF"}, {"version", 1}, {"size", sizeMm}, {"process", process}};
    settings.update(others);
    engine_->configure(settings.dump());
    ASSERT_EQ(Json::parse(engine_->startJob("engrave"))["ok"], true);
    for (Json progress; progress["done"] != true;) {
      progress = Json::parse(engine_->advanceJob("engrave"));
      ASSERT_EQ(progress["ok"], true) << progress;
    }
  }
  /// @returns the last answer
  Json print(PrintedCode& print) const {
    const Json order = Json::parse(engine_->printOrder("{}"))["order"];
    Json said = Json::parse(print.start(writeStl(engine_->carvings().result()->mesh), order.dump()));
    double before = 0;
    while (said["ok"] == true && said["done"] != true) {
      EXPECT_GE(said["fraction"].get<double>(), before);
      before = said["fraction"];
      said = Json::parse(print.advance());
    }
    return said;
  }

  std::unique_ptr<Engine> engine_;
};

TEST_F(PrintedCodeTest, SeesTheSamePrintAsTheCommand) {
  carve(25.2, "fdm-0.4/0.2");
  PrintedCode printed;
  EXPECT_TRUE(printed.pictures("reading").empty());
  const Json said = print(printed);
  ASSERT_EQ(said["ok"], true) << said;
  EXPECT_NEAR(said["facingDeg"].get<double>(), 0, 1e-9);

  const Carvings& carvings = engine_->carvings();
  auto request = printedViewOf(verifyRequestOf(carvings.request(), *carvings.result()));
  ASSERT_TRUE(request && *request);
  auto job = PrintedViewJob::create(carvings.result()->mesh, **request);
  ASSERT_TRUE(job);
  const auto view = runToEnd(**job);
  ASSERT_TRUE(view);
  // The file holds 32-bit coordinates like the mesh, so the surface and the picture are the same.
  EXPECT_EQ(printed.pictures("front").at(0).pixels, view->seen.clean.pixels);
  EXPECT_FALSE(printed.pictures("reading").empty());
}

TEST_F(PrintedCodeTest, SeesFramesInTheSecondColour) {
  for (const char* mark : {"inlay", "paint"}) {
    carve(25.2, "fdm-0.4/0.2", {{"mark", mark}, {"frame", "square"}});
    PrintedCode printed;
    ASSERT_EQ(print(printed)["ok"], true) << mark;
    const GreyImage front = printed.pictures("front").at(0);
    const double module = front.width / (21.0 + 2 * 6);
    const auto at = [&](double fromSymbol) {
      const auto row = static_cast<int>(front.height / 2.0), column = static_cast<int>((6 - fromSymbol) * module);
      return front.pixels.at(static_cast<std::size_t>(row * front.width + column));
    };
    EXPECT_LT(at(5), 0.8 * at(2.5)) << mark;  // in the frame's line, and in the quiet zone
  }
}

TEST_F(PrintedCodeTest, ReportsTheModulesLostInPrint) {
  carve(25.2, "fdm-0.4/0.2");
  PrintedCode printed;
  const std::size_t lostOfLarge = print(printed)["misread"].size();
  carve(7, "fdm-0.4/0.2");  // modules of a third of a millimetre
  const Json said = print(printed);
  EXPECT_LT(lostOfLarge, 4u);
  EXPECT_GT(said["misread"].size(), 10u);
  for (const Json& module : said["misread"])
    for (const Json& place : module) {
      EXPECT_GE(place.get<int>(), 0);
      EXPECT_LT(place.get<int>(), 21);
    }
}

TEST_F(PrintedCodeTest, AddsTheReadingsToTheReportOfTheirCarving) {
  carve(25.2, "fdm-0.4/0.2");
  EXPECT_TRUE(Json::parse(engine_->report())["verification"]["printed"].is_null());
  const int first = engine_->carving();
  engine_->setReadings(R"(["QRELIEF"])", "a decoder");
  const Json barely = Json::parse(engine_->setPrintedReadings(R"(["QRELIEF", "", "", ""])", 0));
  EXPECT_EQ(barely["passed"], false);
  EXPECT_EQ(barely["more"], true) << "a deeper one";
  const Json enough = Json::parse(engine_->setPrintedReadings(R"(["QRELIEF", ""])", 0));
  EXPECT_EQ(enough["passed"], true) << enough;
  const Json report = Json::parse(engine_->report())["verification"];
  EXPECT_EQ(report["printed"]["process"], "fdm-0.4/0.2");
  EXPECT_EQ(report["printed"]["tries"], 2);
  EXPECT_EQ(report["printed"]["reads"], 1);
  EXPECT_EQ(report["verdict"]["prints"]["level"], "good");
  carve(25.2, "resin-0.05");
  EXPECT_TRUE(Json::parse(engine_->report())["verification"]["printed"].is_null());
  ASSERT_TRUE(engine_->useCarving(first));
  EXPECT_EQ(Json::parse(engine_->report())["verification"]["printed"]["reads"], 1);
}

TEST_F(PrintedCodeTest, OffersTheCarvingForPrintBeforeItIsDone) {
  engine_->configure(R"({"text": "QRELIEF", "version": 1, "size": 25.2})");
  EXPECT_TRUE(engine_->exportModel("stl").empty());
  ASSERT_EQ(Json::parse(engine_->startJob("engrave"))["ok"], true);
  Json progress;
  do {
    EXPECT_TRUE(engine_->exportModel("stl").empty());
    EXPECT_EQ(Json::parse(engine_->printOrder("{}"))["ok"], false);
    progress = Json::parse(engine_->advanceJob("engrave"));
    ASSERT_EQ(progress["ok"], true) << progress;
  } while (progress["printable"] != true);
  EXPECT_EQ(progress["done"], false);
  const std::vector<std::uint8_t> stl = engine_->exportModel("stl");
  const std::string order = engine_->printOrder("{}");
  EXPECT_EQ(Json::parse(order)["ok"], true);
  while (progress["done"] != true) progress = Json::parse(engine_->advanceJob("engrave"));
  EXPECT_EQ(engine_->exportModel("stl"), stl);
  EXPECT_EQ(engine_->printOrder("{}"), order);
  EXPECT_FALSE(stl.empty());
}

TEST_F(PrintedCodeTest, TriesAnotherProcessWithoutCarvingAgain) {
  carve(25.2, "fdm-0.4/0.2");
  const std::string changed = R"({"process": "fdm-0.25/0.1", "buildUp": "code-upright"})";
  const Json order = Json::parse(engine_->printOrder(changed))["order"];
  EXPECT_EQ(order["process"]["layerMm"], 0.1);
  EXPECT_EQ(order["process"]["finestMm"], 0.25);
  EXPECT_NEAR(order["buildUp"][2].get<double>(), 0, 1e-12);
  const Json judged = Json::parse(engine_->judgePrint(changed, R"(["QRELIEF"])", 90));
  ASSERT_EQ(judged["ok"], true) << judged;
  EXPECT_EQ(judged["prints"]["level"], "good");
  EXPECT_EQ(judged["prints"]["summary"]["values"]["printing"]["cause"]["values"]["nozzle"]["lengthMm"], 0.25);
  EXPECT_TRUE(Json::parse(engine_->report())["verification"]["printed"].is_null());
  EXPECT_EQ(Json::parse(engine_->printOrder(R"({"process": "clay"})"))["ok"], false);
}

TEST_F(PrintedCodeTest, PrintsNothingWithoutAProcess) {
  EXPECT_EQ(Json::parse(engine_->printOrder("{}"))["ok"], false);  // nothing is carved yet
  carve(25.2, "none");
  EXPECT_FALSE(engine_->exportModel("stl").empty());
  const Json order = Json::parse(engine_->printOrder("{}"));
  EXPECT_EQ(order["ok"], true);
  EXPECT_TRUE(order["order"].is_null());
  EXPECT_EQ(Json::parse(engine_->setPrintedReadings(R"(["QRELIEF"])", 0))["ok"], false);
}

TEST_F(PrintedCodeTest, RefusesAFileThatIsNotAModel) {
  PrintedCode printed;
  EXPECT_EQ(Json::parse(printed.start({1, 2, 3}, "{}"))["ok"], false);
  EXPECT_EQ(Json::parse(printed.advance())["ok"], false);
}

}  // namespace
}  // namespace qrelief
