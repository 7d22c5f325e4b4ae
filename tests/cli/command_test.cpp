// SPDX-License-Identifier: GPL-3.0-or-later
// The command as scripts see it: exit statuses, what is printed where, what is written.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sys/wait.h>

#include "io/read_model.h"
#include "io/write_stl.h"
#include "support/shapes.h"

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

  std::string writeModel(const std::string& name, const Mesh& mesh) const {
    const std::vector<std::uint8_t> bytes = writeStl(mesh);
    std::ofstream(path(name), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return path(name);
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
  EXPECT_EQ(run({"engrave", model, "--text", "x", "--at", "0,0", "-o", path("out.stl")}).status, 2);
  EXPECT_EQ(run({"engrave", model, "--text", "x", "--at", "0,0,40", "-o", path("out.stl"), "--size", "large"}).status,
            2);
  EXPECT_EQ(run({"engrave", model, "--text", "x", "--at", "0,0,40", "-o", path("out.stl"), "--contrast", "7"}).status,
            2);
  EXPECT_EQ(run({"engrave", model, "--text", "x", "--at", "0,0,40", "-o", path("out.stl"), "--pattern", "dots"}).status,
            2);
  for (const char* direction : {"upwards", "1,2", "1,2,x", "0,0,0", "1,2,3,4"})
    EXPECT_EQ(run({"engrave", model, "--text", "x", "--at", "0,0,40", "-o", path("out.stl"), "--direction", direction})
                  .status,
              2)
        << direction;
  EXPECT_FALSE(fs::exists(path("out.stl")));
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
  EXPECT_NE(outcome.err.find("does not fit"), std::string::npos) << outcome.err;
}

TEST_F(CommandTest, ACodeNobodyReadsIsWrittenWithStatusOneAndTheReason) {
  // One layer deep in modules of 4 mm: no shadow to speak of.
  const Outcome outcome = run({"engrave", writeModel("ball.stl", shapes::icosphere(100, 4)), "--text", "x", "--at",
                               "0,0,100", "--size", "70", "--max-depth", "0.1", "--pattern", "thin-plus",
                               "--finder-pattern", "as-modules", "-o", path("out.stl"), "--quiet"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("No reader found the code"), std::string::npos) << outcome.err;
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
  ASSERT_FALSE(info["findings"].empty());
  EXPECT_EQ(info["findings"][0]["code"], "open-edges");
  EXPECT_EQ(info["findings"][0]["count"], 3);
}

TEST_F(CommandTest, VersionAndHelpAreStatusZero) {
  EXPECT_EQ(run({"--version"}).status, 0);
  EXPECT_EQ(run({"--help"}).status, 0);
  EXPECT_EQ(run({"engrave", "--help"}).status, 0);
}

}  // namespace
}  // namespace qrelief
