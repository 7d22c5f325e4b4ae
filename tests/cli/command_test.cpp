// SPDX-License-Identifier: GPL-3.0-or-later
// The command as scripts see it: exit statuses, what is printed where, what is written.
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sys/wait.h>

#include "generate/option_texts.h"
#include "io/read_model.h"
#include "io/write_3mf.h"
#include "io/write_stl.h"
#include "support/shapes.h"
#include "support/zip_file.h"

namespace qrelief {
namespace {

namespace fs = std::filesystem;

struct Outcome {
  int status = -1;
  std::string out, err;
};

std::string contentOf(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class CommandTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / ("qrelief_" + std::string(test->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string writeModel(const std::string& name, const Mesh& mesh) const { return writeBytes(name, writeStl(mesh)); }

  std::string writeBytes(const std::string& name, const std::vector<std::uint8_t>& bytes) const {
    std::ofstream(path(name), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return path(name);
  }

  Result<PolygonSoup> readBack(const std::string& name) const {
    const std::string bytes = contentOf(path(name));
    return readModel(std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), name);
  }

  /// Runs the command; arguments are quoted for the shell.
  Outcome run(const std::vector<std::string>& arguments) const {
    std::string line = "'" QRELIEF_COMMAND "'";
    for (const std::string& argument : arguments) line += " '" + argument + "'";
    line += " >'" + path("stdout") + "' 2>'" + path("stderr") + "'";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contentOf(path("stdout")), contentOf(path("stderr"))};
  }

  fs::path folder_;
};

TEST_F(CommandTest, EngravesAModelAndWritesMeshReportAndPreview) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(40, 5));
  const Outcome outcome = run({"engrave", model, "--text", "https://qrelief.example", "--at", "0,0,40", "--size", "25",
                               "-o", path("out.stl"), "--report", path("out.json"), "--preview", path("out.png")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("reads as: https://qrelief.example"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("Finding the depth"), std::string::npos);

  const auto report = nlohmann::json::parse(contentOf(path("out.json")));
  const std::string stl = contentOf(path("out.stl"));
  const auto soup = readModel(std::span(reinterpret_cast<const std::uint8_t*>(stl.data()), stl.size()), "out.stl");
  ASSERT_TRUE(soup.has_value());
  EXPECT_EQ(soup->triangles.size(), report["mesh"]["triangles"].get<std::size_t>());
  EXPECT_TRUE(report["verification"]["decoded"].get<bool>());
  EXPECT_GT(report["timingsMs"]["total"].get<double>(), report["timingsMs"]["depthSearch"].get<double>());
  EXPECT_EQ(contentOf(path("out.png")).substr(1, 3), "PNG");
}

TEST_F(CommandTest, QuietPrintsNoProgress) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(40, 4));
  const Outcome outcome =
      run({"engrave", model, "--text", "x", "--at", "0,0,40", "--size", "25", "-o", path("out.stl"), "--quiet"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
}

TEST_F(CommandTest, UnitsScaleModelAndCentre) {
  Mesh metres = shapes::icosphere(40, 4);
  for (Vec3f& p : metres.positions) p *= 0.001f;
  const std::string model = writeModel("ball.stl", metres);
  const Outcome outcome = run({"engrave", model, "--text", "x", "--units", "m", "--at", "0,0,0.04", "--size", "25",
                               "-o", path("out.stl"), "--report", path("out.json"), "--quiet"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto report = nlohmann::json::parse(contentOf(path("out.json")));
  EXPECT_EQ(report["input"]["scaleToMm"], 1000);
  EXPECT_NEAR(report["projection"]["centre"][2].get<double>(), 40, 0.1);
}

TEST_F(CommandTest, WritesTheSameSolidInEveryFormat) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(40, 4));
  const auto engrave = [&](const std::string& output, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"engrave", model, "--text", "x",          "--at",   "0,0,40",
                                          "--size",  "25",  "-o",     path(output), "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << output << ": " << outcome.err;
    return readBack(output);
  };
  const auto binary = engrave("out.stl");
  ASSERT_TRUE(binary);
  for (const auto& other :
       {engrave("out.STL", {"--ascii"}), engrave("out.obj"), engrave("out.ply"), engrave("out.3mf")}) {
    ASSERT_TRUE(other) << other.error().message;
    ASSERT_EQ(other->triangles.size(), binary->triangles.size()) << other->format;
    for (std::size_t t = 0; t < binary->triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_EQ(Vec3f(other->positions[other->triangles[t][k]]), Vec3f(binary->positions[binary->triangles[t][k]]))
            << other->format << ", triangle " << t;
  }
  EXPECT_EQ(readBack("out.STL")->format, "STL (ASCII)");
}

/// Volume of the soup's triangles from `first` up to `end`, outwards.
double volumeOf(const PolygonSoup& soup, std::size_t first, std::size_t end) {
  double sixfold = 0;
  for (std::size_t t = first; t < end; ++t) {
    const auto& [a, b, c] = soup.triangles[t];
    sixfold += glm::dot(soup.positions[a], glm::cross(soup.positions[b], soup.positions[c]));
  }
  return sixfold / 6;
}

TEST_F(CommandTest, TheInlayFillsThePocketsOfTheCarvedObjectAndTheOtherObjectStaysAsItWas) {
  const std::vector<ModelObject> objects = {
      {"ball", {{"", shapes::icosphere(40, 4), {}}}},
      {"cube", {{"", shapes::translated(shapes::box({5, 6, 7}), {100, 0, 0}), {}}}}};
  const std::string model = writeBytes("two.3mf", *write3mf(objects, {}));
  const auto engraved = [&](const std::string& output, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"engrave", model, "--text", "x",          "--at",   "0,0,40",
                                          "--size",  "25",  "-o",     path(output), "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return readBack(output);
  };
  const auto plain = engraved("plain.3mf", {});
  const auto inlaid = engraved("inlaid.3mf", {"--inlay"});
  const auto original = readBack("two.3mf");
  ASSERT_TRUE(plain && inlaid && original);
  for (const auto* soup : {&*plain, &*inlaid}) {
    ASSERT_EQ(soup->parts.size(), 2u);
    EXPECT_EQ(soup->parts[0].name, "ball");
    EXPECT_EQ(soup->parts[1].name, "cube");
    const std::size_t cube = soup->parts[1].firstTriangle;
    ASSERT_EQ(soup->triangles.size(), cube + 12);
    for (std::size_t t = 0; t < 12; ++t)
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(soup->positions[soup->triangles[cube + t][k]],
                  original->positions[original->triangles[original->parts[1].firstTriangle + t][k]]);
  }
  // One object after the other, the inlay behind the body that it fills.
  const std::size_t carved = plain->parts[1].firstTriangle, filled = inlaid->parts[1].firstTriangle;
  ASSERT_GT(filled, carved);
  const double whole = volumeOf(*original, 0, original->parts[1].firstTriangle);
  const double body = volumeOf(*inlaid, 0, carved), inlay = volumeOf(*inlaid, carved, filled);
  EXPECT_EQ(body, volumeOf(*plain, 0, carved));
  EXPECT_NEAR((body + inlay) / whole, 1, 1e-6);
}

TEST_F(CommandTest, AnInlayIsFor3mfOnly) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(40, 3));
  for (const char* output : {"out.stl", "out.obj", "out.ply"}) {
    const Outcome outcome =
        run({"engrave", model, "--text", "x", "--at", "0,0,40", "-o", path(output), "--inlay", "--quiet"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find("--inlay needs two bodies"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(path(output)));
  }
}

TEST_F(CommandTest, A3mfBringsItsOwnUnitUnlessToldOtherwise) {
  const std::string model =
      writeBytes("box.3mf", zip_file::threeMf(zip_file::modelPart(zip_file::boxObject(1, 2, 3, 1),
                                                                  "<item objectid=\"1\"/>", "unit=\"inch\"")));
  const auto sizeWith = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"info", model, "--json", path("info.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run(arguments).status, 0);
    return nlohmann::json::parse(contentOf(path("info.json")))["sizeMm"][0].get<double>();
  };
  EXPECT_NEAR(sizeWith({}), 50.8, 1e-5);
  EXPECT_NEAR(sizeWith({"--units", "cm"}), 20, 1e-5);
  EXPECT_NEAR(sizeWith({"--scale", "1"}), 2, 1e-5);

  const Outcome outcome = run({"engrave", model, "--text", "x", "--at", "1,1.5,1", "--size", "25", "-o",
                               path("out.3mf"), "--report", path("out.json"), "--quiet"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto report = nlohmann::json::parse(contentOf(path("out.json")));
  EXPECT_EQ(report["input"]["scaleToMm"], 25.4);
  EXPECT_NEAR(report["projection"]["centre"][0].get<double>(), 25.4, 1e-4);
}

TEST_F(CommandTest, DirectionsAndSizesGoByTheNamesOfTheContract) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(40, 4));
  const auto engraved = [&](const std::string& direction, const std::string& size) {
    const Outcome outcome =
        run({"engrave", model, "--text", "x", "--at", "0,0,40", "--direction", direction, "--size", size, "--max-size",
             "25", "-o", path("out.stl"), "--report", path("out.json"), "--quiet"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(contentOf(path("out.json")));
  };
  for (const std::string direction : {"mean-normal", "depth-balanced", "pca", "optimal"})
    EXPECT_EQ(engraved(direction, "25")["projection"]["method"], direction);
  const auto given = engraved("0.1,0,1", "best");
  EXPECT_EQ(given["projection"]["method"], "given");
  EXPECT_NEAR(given["projection"]["normal"][0].get<double>(), 0.1 / std::sqrt(1.01), 1e-9);
  EXPECT_EQ(given["size"]["mode"], "best");
  EXPECT_TRUE(given["size"].contains("rotationDeg"));
}

TEST_F(CommandTest, TheSymbolIsMadeAsAskedFor) {
  const std::string model = writeModel("plate.stl", shapes::box({60, 60, 8}));
  const Outcome outcome = run({"engrave", model, "--at", "0,0,4", "--text", "QRELIEF", "--version", "3", "--raise-ecc",
                               "--mask", "5", "--break-up", "-o", path("out.stl"), "--report", path("r.json")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto symbol = nlohmann::json::parse(contentOf(path("r.json")))["symbol"];
  EXPECT_EQ(symbol["ecc"], "H");
  EXPECT_EQ(symbol["mask"], 5);
  EXPECT_EQ(symbol["correctableCodewords"], 11);  // 3-H: two blocks with 22 check codewords each
  EXPECT_EQ(symbol["spentCodewords"], 7);         // 3-L corrects 7 in its one block: each keeps 4
  EXPECT_GE(symbol["flippedModules"], 14);
}

TEST_F(CommandTest, ADirectionFromBehindIsNoSolution) {
  const Outcome outcome = run({"engrave", writeModel("ball.stl", shapes::icosphere(40, 3)), "--text", "x", "--at",
                               "0,0,40", "--direction", "0,0,-1", "-o", path("out.stl"), "--quiet"});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.err.find("faces away"), std::string::npos) << outcome.err;
}

TEST_F(CommandTest, BadUsageIsStatusTwo) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(40, 3));
  EXPECT_EQ(run({}).status, 2);
  EXPECT_EQ(run({"engrave", model}).status, 2);
  EXPECT_EQ(run({"engrave", model, "--text", "x", "--at", "0,0,40", "-o", path("out.step")}).status, 2);
  EXPECT_EQ(run({"engrave", model, "--text", "x", "--at", "0,0,40", "-o", path("out.off")}).status, 2);
  EXPECT_EQ(run({"engrave", model, "--text", "x", "--at", "0,0,40", "-o", path("out.obj"), "--ascii"}).status, 2);
  EXPECT_EQ(run({"engrave", model, "--text", "x", "--at", "0,0", "-o", path("out.stl")}).status, 2);
  EXPECT_EQ(run({"engrave", model, "--text", "x", "--at", "0,0,40", "-o", path("out.stl"), "--size", "large"}).status,
            2);
  EXPECT_EQ(run({"engrave", model, "--text", "x", "--at", "0,0,40", "-o", path("out.stl"), "--contrast", "7"}).status,
            2);
  EXPECT_EQ(run({"engrave", model, "--text", "x", "-o", path("out.stl"), "--contrast", "1"}).status, 2)
      << "a spot first";
  EXPECT_EQ(run({"engrave", model, "--text", "x", "--at", "0,0,40", "-o", path("out.stl"), "--pattern", "dots"}).status,
            2);
  for (const char* direction : {"upwards", "1,2", "1,2,x", "0,0,0", "1,2,3,4"})
    EXPECT_EQ(run({"engrave", model, "--text", "x", "--at", "0,0,40", "-o", path("out.stl"), "--direction", direction})
                  .status,
              2)
        << direction;
  EXPECT_FALSE(fs::exists(path("out.stl")));
}

TEST_F(CommandTest, EverySettingIsAFlagOfEngraveAndInItsHelp) {
  const std::string help = run({"engrave", "--help"}).out;
  for (const Setting& setting : settings()) {
    const OptionTexts texts = optionTexts(setting);
    EXPECT_NE(help.find("\n  " + texts.flag + " "), std::string::npos) << texts.flag;
    EXPECT_NE(help.find(texts.help), std::string::npos) << texts.flag;
  }
}

TEST_F(CommandTest, ANumberOutOfItsRangeIsRefusedWithItsFlagBeforeTheModelIsRead) {
  for (const Setting& setting : settings()) {
    if (!setting.takesNumber()) continue;
    const std::string flag = optionTexts(setting).flag;
    for (const double value : {setting.min - 1, 2 * setting.max + 1}) {
      const Outcome outcome =
          run({"engrave", path("missing.stl"), "--text", "x", "-o", path("out.stl"), flag, fmt::format("{}", value)});
      EXPECT_EQ(outcome.status, 2) << flag;
      EXPECT_NE(outcome.err.find("qrelief: error: " + flag + " is "), std::string::npos) << outcome.err;
      EXPECT_NE(outcome.err.find("what helps: Choose from"), std::string::npos) << outcome.err;
    }
  }
}

TEST_F(CommandTest, WhatIsNoChoiceIsRefusedWithThoseThereAre) {
  const Outcome outcome =
      run({"engrave", path("missing.stl"), "--text", "x", "-o", path("out.stl"), "--pattern", "dots"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("--pattern is \"dots\""), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("none, square, thin-plus, diamond, thick-plus"), std::string::npos) << outcome.err;
}

TEST_F(CommandTest, BadInputIsStatusThreeAndSaysWhatHelps) {
  EXPECT_EQ(run({"info", path("missing.stl")}).status, 3);
  std::ofstream(path("empty.stl"));
  EXPECT_EQ(run({"info", path("empty.stl")}).status, 3);

  Mesh open = shapes::box({40, 40, 40});
  open.triangles.pop_back();
  const Outcome outcome =
      run({"engrave", writeModel("open.stl", open), "--text", "x", "--at", "0,0,20", "-o", path("out.stl")});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("what helps"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(path("out.stl")));
}

TEST_F(CommandTest, NoSolutionIsStatusFour) {
  const Outcome outcome = run({"engrave", writeModel("ball.stl", shapes::icosphere(20, 4)), "--text", "x", "--at",
                               "0,0,20", "--size", "60", "-o", path("out.stl")});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.err.find("There is no room here for a code of 60 mm"), std::string::npos) << outcome.err;
}

TEST_F(CommandTest, ACodeNobodyReadsIsWrittenWithStatusOneAndTheReason) {
  // One layer deep in modules of 4 mm: no shadow to speak of.
  const Outcome outcome = run({"engrave", writeModel("ball.stl", shapes::icosphere(100, 4)), "--text", "x", "--at",
                               "0,0,100", "--size", "70", "--max-depth", "0.1", "--pattern", "thin-plus",
                               "--finder-pattern", "as-modules", "-o", path("out.stl"), "--quiet"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("0 of 72 tries"), std::string::npos) << outcome.err;
  EXPECT_TRUE(fs::exists(path("out.stl")));
}

TEST_F(CommandTest, AnUnwritablePlaceIsAnErrorAndLeavesNothingBehind) {
  const Outcome outcome = run({"engrave", writeModel("ball.stl", shapes::icosphere(40, 4)), "--text", "x", "--at",
                               "0,0,40", "--size", "25", "-o", path("no_such_folder/out.stl"), "--quiet"});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("no_such_folder"), std::string::npos);
}

TEST_F(CommandTest, InfoTellsSizeAndFindings) {
  Mesh open = shapes::box({40, 30, 20});
  open.triangles.pop_back();
  const Outcome outcome = run({"info", writeModel("open.stl", open), "--json", path("info.json")});
  EXPECT_EQ(outcome.status, 0);
  const auto info = nlohmann::json::parse(contentOf(path("info.json")));
  EXPECT_EQ(info["sizeMm"], nlohmann::json({40, 30, 20}));
  EXPECT_FALSE(info["engravable"].get<bool>());
  ASSERT_EQ(info["findings"].size(), 2u);
  EXPECT_EQ(info["findings"][0]["code"], "large-openings");
  EXPECT_EQ(info["findings"][1]["code"], "open-edges");
  EXPECT_EQ(info["findings"][1]["count"], 3);
  EXPECT_EQ(info["findings"][1]["values"]["count"], nlohmann::json({{"count", 3}}));
  EXPECT_EQ(info["findings"][1]["severity"], "blocking");
  EXPECT_NE(info["findings"][1]["message"].get<std::string>().find("3 open edges, one at ("), std::string::npos);
  EXPECT_NE(info["findings"][1]["hint"], "");
}

TEST_F(CommandTest, WarningsAndErrorsAreToldApartNameTheFileAndSayWhatHelps) {
  const std::string tiny = writeModel("tiny.stl", shapes::box({0.2, 0.1, 0.15}));
  const Outcome outcome = run({"engrave", tiny, "--text", "x", "--at", "0,0,0.075", "-o", path("out.stl"), "--quiet"});
  EXPECT_EQ(outcome.status, 4);
  const std::string helps = "--units m makes it 200 × 100 × 150 mm";
  const std::size_t warning = outcome.err.find("qrelief: warning: tiny.stl: The model is tiny: 0.2 × 0.1 × 0.15 mm\n");
  const std::size_t error = outcome.err.find("qrelief: error: tiny.stl: The model has no room for any code");
  ASSERT_NE(warning, std::string::npos) << outcome.err;
  ASSERT_NE(error, std::string::npos) << outcome.err;
  EXPECT_LT(outcome.err.find("  what helps: If it should be larger, " + helps, warning), error) << outcome.err;
  EXPECT_NE(outcome.err.find("  what helps: If it should be larger, " + helps, error), std::string::npos);
  EXPECT_NE(run({"place", tiny, "--quiet"}).err.find("  what helps: If it should be larger, " + helps),
            std::string::npos);
  EXPECT_EQ(run({"engrave", tiny, "--text", "x", "--at", "0,0,0.075", "-o", path("out.stl"), "--contrast", "3"})
                .err.find("error: tiny.stl: The contrast"),
            std::string::npos);
}

TEST_F(CommandTest, RepairsAreSwitchedByOptions) {
  Mesh open = shapes::icosphere(40, 3);
  open.triangles.pop_back();
  const std::string model = writeModel("open.stl", open);
  EXPECT_NE(run({"info", model}).out.find("1 hole was filled"), std::string::npos);
  EXPECT_NE(run({"info", model, "--no-repair", "weld,holes"}).out.find("3 open edges"), std::string::npos);
  EXPECT_NE(run({"info", model, "--max-hole", "0.1"}).out.find("too large to be filled"), std::string::npos);
  EXPECT_EQ(run({"info", model, "--max-hole", "wide"}).status, 2);
  EXPECT_EQ(run({"info", model, "--weld-tolerance", "-1"}).status, 2);
  EXPECT_EQ(run({"info", model, "--no-repair", "colours"}).status, 2);
  EXPECT_EQ(
      run({"engrave", model, "--text", "x", "--at", "0,0,40", "-o", path("out.stl"), "--no-repair", "all"}).status, 3);
}

TEST_F(CommandTest, LampsAreTakenFromTheOptionAndSaidInTheReport) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(40, 4));
  const std::vector<std::string> engraving = {"engrave", model, "--text",        "x",      "--at", "0,0,40", "--size",
                                              "25",      "-o",  path("out.stl"), "--quiet"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), engraving.begin(), engraving.end());
    return run(more);
  };
  const Outcome outcome = with({"--light", "90,60", "--light", "0,75,0.5", "--report", path("out.json")});
  EXPECT_LE(outcome.status, 1) << outcome.err;
  const auto report = nlohmann::json::parse(contentOf(path("out.json")));
  EXPECT_EQ(report["depth"]["lights"],
            nlohmann::json::parse(R"([{"azimuthDeg": 90.0, "elevationDeg": 60.0, "strength": 1.0},
                                      {"azimuthDeg": 0.0, "elevationDeg": 75.0, "strength": 0.5}])"));
  EXPECT_EQ(with({"--light", "90"}).status, 2);
  EXPECT_EQ(with({"--light", "90,high"}).status, 2);
  EXPECT_EQ(with({"--light", "90,0"}).status, 2);
  EXPECT_EQ(with({"--light", "90,45,-1"}).status, 2);
  EXPECT_EQ(with({"--light", "1,45", "--light", "2,45", "--light", "3,45"}).status, 2);
}

TEST_F(CommandTest, VersionAndHelpAreStatusZero) {
  EXPECT_EQ(run({"--version"}).status, 0);
  EXPECT_EQ(run({"--help"}).status, 0);
  EXPECT_EQ(run({"engrave", "--help"}).status, 0);
}

TEST_F(CommandTest, PlaceOffersSpotsThatEngraveTakesAsPrinted) {
  const std::string model = writeModel("ball.stl", shapes::bumpySphere(40, 2, 5, 5));
  const Outcome placed = run({"place", model, "--size", "20", "--count", "3", "--json", path("spots.json"), "--quiet"});
  ASSERT_EQ(placed.status, 0) << placed.err;
  EXPECT_EQ(placed.out.substr(0, 8), "1: --at ");
  const auto json = nlohmann::json::parse(contentOf(path("spots.json")));
  ASSERT_EQ(json["spots"].size(), 3u);
  EXPECT_EQ(json["parameters"]["sizeMm"], 20);
  EXPECT_GE(json["parameters"]["views"], 200);
  const std::string at = placed.out.substr(8, placed.out.find(' ', 8) - 8);
  const Outcome engraved =
      run({"engrave", model, "--text", "HELLO", "--at", at, "--size", "20", "-o", path("out.stl"), "--quiet"});
  EXPECT_EQ(engraved.status, 0) << at << engraved.err;
}

TEST_F(CommandTest, PlaceExitsWithFourAndTheLargestSizeWhereNothingFits) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(20, 4));
  const Outcome outcome = run({"place", model, "--size", "50", "--quiet"});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.err.find("the largest found is "), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

TEST_F(CommandTest, PresetsDifferInDepthAndGiveWayToWhatIsSaid) {
  const std::string model = writeModel("box.stl", shapes::box({40, 40, 8}));
  const auto meanDepth = [&](std::vector<std::string> options) {
    std::vector<std::string> words = {"engrave", model, "--text", "HELLO",         "--at",     "0,0,4",
                                      "--size",  "21",  "-o",     path("out.stl"), "--report", path("out.json"),
                                      "--quiet"};
    words.insert(words.end(), options.begin(), options.end());
    const Outcome outcome = run(words);
    EXPECT_LE(outcome.status, 1) << outcome.err;
    return nlohmann::json::parse(contentOf(path("out.json")))["depth"]["meanMm"].get<double>();
  };
  const double balanced = meanDepth({});
  EXPECT_EQ(meanDepth({"--preset", "balanced"}), balanced);
  EXPECT_LT(meanDepth({"--preset", "shallow"}), balanced);
  EXPECT_GT(meanDepth({"--preset", "robust"}), balanced);
  EXPECT_EQ(meanDepth({"--preset", "robust", "--contrast", "0.3"}), balanced);
  EXPECT_EQ(run({"engrave", model, "--text", "HELLO", "--preset", "deep", "-o", path("out.stl")}).status, 2);
}

TEST_F(CommandTest, WhatDoesNotReadAsShallowAsAskedForIsCarvedDeeper) {
  const double slope = std::tan(40 * std::numbers::pi / 180);  // its own shade runs through the code
  const Mesh valley = shapes::plate({60, 60}, 60, 2, 2, [&](double x, double) { return slope * std::abs(x); });
  const std::string model = writeModel("valley.stl", valley);
  const auto engrave = [&](std::vector<std::string> options) {
    std::vector<std::string> words = {"engrave",     model,           "--text",   "HELLO",          "--at",   "0,0,0",
                                      "--direction", "0,0,1",         "--up",     "0,1,0",          "--size", "30",
                                      "-o",          path("out.stl"), "--report", path("out.json"), "--quiet"};
    words.insert(words.end(), options.begin(), options.end());
    return run(words);
  };
  const auto depth = [&] { return nlohmann::json::parse(contentOf(path("out.json")))["depth"]; };
  const Outcome kept = engrave({"--preset", "shallow", "--keep-preset"});
  EXPECT_EQ(kept.status, 1);
  EXPECT_NE(kept.err.find("of 72 tries on simulated pictures read the code"), std::string::npos) << kept.err;
  EXPECT_EQ(depth()["preset"], "shallow");
  EXPECT_EQ(engrave({"--contrast", "0.2"}).status, 1) << "what is said by itself is kept, too";
  EXPECT_FALSE(depth().contains("preset"));

  const Outcome deeper = engrave({"--preset", "shallow"});
  EXPECT_EQ(deeper.status, 0) << deeper.err;
  EXPECT_NE(deeper.out.find("carved as balanced: as shallow the code did not read reliably"), std::string::npos)
      << deeper.out;
  EXPECT_EQ(depth()["askedPreset"], "shallow");
  EXPECT_EQ(depth()["preset"], "balanced");
  EXPECT_EQ(depth()["contrast"], 0.3);
}

TEST_F(CommandTest, EngravesTheBestSpotWhereNoCentreIsGiven) {
  const std::string model = writeModel("cube.stl", shapes::box({60, 60, 60}));
  const Outcome outcome = run({"engrave", model, "--text", "HELLO", "-o", path("out.stl"), "--quiet"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.substr(0, 10), "placed at ");
  EXPECT_NE(outcome.out.find("reads as: HELLO"), std::string::npos);
}

TEST_F(CommandTest, VerifyReadsWhatEngraveWroteAndSaysWhatIsWrongWithOtherModels) {
  const std::string model = writeModel("box.stl", shapes::box({40, 40, 8}));
  ASSERT_EQ(run({"engrave", model, "--text", "HELLO", "--at", "0,0,4", "--size", "25.2", "-o", path("out.3mf"),
                 "--report", path("out.json"), "--quiet"})
                .status,
            0);
  const Outcome good = run({"verify", path("out.3mf"), "--report", path("out.json"), "--json", path("verified.json"),
                            "--nozzle", "0.9", "--quick", "--quiet"});
  EXPECT_EQ(good.status, 0) << good.err;
  EXPECT_NE(good.out.find("reads as: HELLO"), std::string::npos) << good.out;
  EXPECT_NE(good.out.find("0.9 mm nozzle: choose a module of 1.35 mm or more"), std::string::npos) << good.out;
  EXPECT_EQ(good.err, "");
  const auto json = nlohmann::json::parse(contentOf(path("verified.json")));
  EXPECT_EQ(json["verified"], true);
  EXPECT_EQ(json["input"]["format"], "3MF");

  const Outcome plain = run({"verify", model, "--report", path("out.json"), "--quick", "--quiet"});
  EXPECT_EQ(plain.status, 1);
  EXPECT_NE(plain.err.find("No carved modules of this code"), std::string::npos) << plain.err;
}

TEST_F(CommandTest, VerifyNeedsToKnowTheCodesPlace) {
  const std::string model = writeModel("box.stl", shapes::box({40, 40, 8}));
  const Outcome nowhere = run({"verify", model, "--text", "HELLO", "--quiet"});
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_NE(nowhere.err.find("--at"), std::string::npos) << nowhere.err;
  EXPECT_EQ(run({"verify", model, "--report", path("missing.json"), "--quiet"}).status, 3);
  std::ofstream(path("broken.json")) << "{}";
  const Outcome broken = run({"verify", model, "--report", path("broken.json"), "--quiet"});
  EXPECT_EQ(broken.status, 3);
  EXPECT_NE(broken.err.find("text"), std::string::npos) << broken.err;
}

}  // namespace
}  // namespace qrelief
