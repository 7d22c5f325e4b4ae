// SPDX-License-Identifier: GPL-3.0-or-later
// `qrelief engrave`: effects of its options, and the files it writes.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <sys/stat.h>
#include <thread>

#include "cli/command_fixture.h"
#include "io/three_mf/write_3mf.h"
#include "io/write_model.h"
#include "support/shapes.h"
#include "support/zip_file.h"

namespace qrelief {
namespace {

using EngraveCommandTest = CommandTest;
using testing::HasSubstr;

TEST_F(EngraveCommandTest, EngravesAModelAndWritesMeshReportAndPreview) {
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

/// Returns the percentages of the progress lines.
std::vector<int> percentages(const std::string& err) {
  std::vector<int> found;
  std::istringstream lines(err);
  for (std::string line; std::getline(lines, line);)
    if (const auto at = line.find(" % "); at != std::string::npos && at < 4) found.push_back(std::stoi(line));
  return found;
}

TEST_F(EngraveCommandTest, ShowsProgressThatNeverGoesBackAndEndsAtAHundred) {
  const std::string model = writeModel("box.stl", shapes::box({60, 60, 20}));
  const std::vector<std::string> engraving = {"engrave", model,    "--text", "x",  "--at",
                                              "0,0,10",  "--size", "9",      "-o", path("out.stl")};
  const auto progressWith = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments = engraving;
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    const bool tried = outcome.out.find("engraved for other ways of printing") != std::string::npos;
    EXPECT_EQ(tried, std::find(more.begin(), more.end(), "fdm-0.6/0.3") != more.end()) << outcome.out << outcome.err;
    return percentages(outcome.err);
  };
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--process", "none"},
                                               {"--process", "none", "--try-prints"},
                                               {"--process", "fdm-0.6/0.3", "--try-prints"}}) {
    const std::vector<int> shown = progressWith(more);
    ASSERT_GT(shown.size(), 3u);
    EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end())) << testing::PrintToString(shown);
    EXPECT_EQ(shown.front(), 0);
    EXPECT_EQ(shown.back(), 100);
    EXPECT_EQ(std::count(shown.begin(), shown.end(), 100), 1);
  }
}

TEST_F(EngraveCommandTest, EngravesWhereNoGlContextCanBeMade) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(40, 4));
  ASSERT_EQ(setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null", 1), 0);  // EGL finds no implementation
  const Outcome outcome = run({"engrave", model, "--text", "x", "--at", "0,0,40", "--size", "25", "-o", path("out.stl"),
                               "--report", path("out.json"), "--quiet"});
  unsetenv("__EGL_VENDOR_LIBRARY_FILENAMES");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto report = nlohmann::json::parse(contentOf(path("out.json")));
  EXPECT_EQ(report["gl"]["renderer"], "processor");
  EXPECT_TRUE(report["verification"]["decoded"].get<bool>());
}

TEST_F(EngraveCommandTest, UnitsScaleModelAndCentre) {
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

TEST_F(EngraveCommandTest, WritesTheSameSolidInEveryFormat) {
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

TEST_F(EngraveCommandTest, AnObjKeepsTheNamesOfItsBodies) {
  const std::vector<ModelObject> objects = {{"",
                                             {{"ball", shapes::icosphere(40, 4), {}},
                                              {"cube", shapes::translated(shapes::box({5, 6, 7}), {100, 0, 0}), {}}}}};
  const std::string model = writeBytes("two.obj", *qrelief::writeModel(objects, ModelFormat::Obj));
  const Outcome outcome =
      run({"engrave", model, "--text", "x", "--at", "0,0,40", "--size", "25", "-o", path("out.obj"), "--quiet"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto soup = readBack("out.obj");
  ASSERT_TRUE(soup);
  ASSERT_EQ(soup->bodies.size(), 2u);
  EXPECT_EQ(soup->bodies[0].name, "ball");
  EXPECT_EQ(soup->bodies[1].name, "cube");
  EXPECT_EQ(std::count(soup->bodyOf.begin(), soup->bodyOf.end(), 1u), 12);
}

TEST_F(EngraveCommandTest, CarvesALabelAndAFrame) {
  const std::string model = writeModel("plate.stl", shapes::plate({60, 60}, 5, 4, 4));
  const auto engraved = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"engrave", model,   "--text",        "x",        "--at",          "0,0,5",
                                          "--up",    "0,1,0", "--size",        "25",       "--process",     "none",
                                          "--quiet", "-o",    path("out.stl"), "--report", path("out.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(contentOf(path("out.json")));
  };
  const auto plain = engraved({}), labelled = engraved({"--label", "No. 7", "--frame", "rounded"});
  EXPECT_TRUE(plain["label"].is_null());
  EXPECT_EQ(labelled["label"]["text"], "No. 7");
  EXPECT_EQ(labelled["label"]["frame"], "rounded");
  EXPECT_NEAR(labelled["label"]["depthMm"].get<double>(), 0.4, 1e-9);
  EXPECT_NEAR(labelled["label"]["capitalMm"].get<double>(), 25.0 / 8, 1e-9);
  EXPECT_LT(labelled["mesh"]["volumeMm3"].get<double>(), plain["mesh"]["volumeMm3"].get<double>() - 20);
  EXPECT_EQ(labelled["colour"]["changes"], 0);
}

TEST_F(EngraveCommandTest, NamesABodyThatLiesInThePlaceOfAnother) {
  const std::string item = "<item objectid=\"1\"/>";
  const std::string model =
      writeBytes("twice.3mf", zip_file::threeMf(zip_file::modelPart(zip_file::boxObject(1, 40, 40, 10), item + item)));
  for (const char* mark : {"shadow", "paint"}) {
    const Outcome outcome = run({"engrave", model, "--text", "x", "-o", path("x.3mf"), "--mark", mark, "--quiet"});
    EXPECT_EQ(outcome.status, 4) << mark;
    EXPECT_NE(outcome.err.find("Another shell of the model has its surface in the same place"), std::string::npos)
        << outcome.err;
  }
}

TEST_F(EngraveCommandTest, ReadsAModelFromAPipe) {
  const std::string bytes = contentOf(writeModel("box.stl", shapes::box({40, 40, 8})));
  ASSERT_EQ(mkfifo(path("pipe.stl").c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(path("pipe.stl"), std::ios::binary) << bytes; });
  const Outcome outcome = run({"info", path("pipe.stl")});
  writer.join();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("12 triangles"), std::string::npos) << outcome.out;
}

TEST_F(EngraveCommandTest, RefusesPicturesOfAnotherFormat) {
  const std::string model = writeModel("box.stl", shapes::box({40, 40, 8}));
  const Outcome outcome =
      run({"engrave", model, "--text", "x", "-o", path("x.stl"), "--preview", path("x.jpg"), "--quiet"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("choose a name that ends in .png"), std::string::npos) << outcome.err;
}

TEST_F(EngraveCommandTest, ChecksTheNamesOfItsFilesBeforeAnyWork) {
  const std::string model = writeModel("box-2.stl", shapes::box({40, 40, 8}));
  const std::string before = contentOf(model);
  const auto refused = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments = {"engrave", model, "--text", "x", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(contentOf(model), before);
    EXPECT_EQ(outcome.out, "");
    return outcome;
  };
  EXPECT_EQ(refused({"-o", path("x.stl"), "--report", path("x.stl")}).status, 2);
  EXPECT_EQ(refused({"-o", path("x.stl"), "--report", path("./X.STL")}).status, 2);
  EXPECT_EQ(refused({"-o", path("x.stl"), "--report", path("r.png"), "--preview", path("r.png")}).status, 2);
  EXPECT_EQ(refused({"-o", model}).status, 2);
  EXPECT_EQ(refused({"-o", path("x.stl"), "--report", model}).status, 2);
  const Outcome second = refused({"-o", path("box.stl"), "--mark", "inlay"});
  EXPECT_EQ(second.status, 2);
  EXPECT_NE(second.err.find("the second file of -o would overwrite"), std::string::npos) << second.err;
  EXPECT_EQ(refused({"-o", path("box.stl"), "--mark", "auto"}).status, 2);
  const Outcome folder = refused({"-o", path("none/x.stl")});
  EXPECT_EQ(folder.status, 3);
  EXPECT_NE(folder.err.find("No such file or directory"), std::string::npos) << folder.err;
  EXPECT_EQ(refused({"-o", path("x.stl"), "--report", path("box-2.stl/r.json")}).status, 3);
  std::filesystem::create_directory(path("folder.stl"));
  EXPECT_EQ(refused({"-o", path("folder.stl")}).status, 3);
  std::filesystem::create_symlink(model, path("link.stl"));
  EXPECT_EQ(refused({"-o", path("link.stl")}).status, 2) << "a link to the model";
}

TEST_F(EngraveCommandTest, RefusesFilesThatCannotBeWrittenBeforeAnyWork) {
  const std::string model = writeModel("plate.stl", shapes::plate({40, 40}, 5, 4, 4));
  ASSERT_EQ(mkfifo(path("pipe.stl").c_str(), 0600), 0);
  const auto refusal = [&](const std::string& output) {
    const Outcome outcome =
        run({"engrave", model, "--text", "a", "-o", output, "--at", "0,0,5", "--size", "21", "--process", "none"});
    EXPECT_EQ(outcome.status, 3) << output;
    EXPECT_EQ(outcome.err.find('%'), std::string::npos) << "no work yet: " << outcome.err;
    return outcome.err;
  };
  EXPECT_THAT(refusal("/proc/x.stl"), HasSubstr("/proc/x.stl cannot be written"));
  EXPECT_THAT(refusal(path("pipe.stl")), HasSubstr("it is a pipe or a device, not a file"));
  EXPECT_TRUE(std::filesystem::is_fifo(path("pipe.stl")));
  std::filesystem::create_symlink(path("pipe.stl"), path("link.stl"));
  EXPECT_THAT(refusal(path("link.stl")), HasSubstr("it is a pipe or a device, not a file"));
  EXPECT_THAT(refusal(path(std::string(252, 'x') + ".stl")), HasSubstr("File name too long"));
}

TEST_F(EngraveCommandTest, WritesTheFileThatALinkLeadsTo) {
  const std::string model = writeModel("plate.stl", shapes::plate({40, 40}, 5, 4, 4));
  std::filesystem::create_directory(path("elsewhere"));
  const std::string file = path("elsewhere/code.stl");
  std::ofstream(file) << "old";
  std::filesystem::create_symlink(file, path("link.stl"));
  const Outcome outcome = run(
      {"engrave", model, "--text", "a", "-o", path("link.stl"), "--at", "0,0,5", "--size", "21", "--process", "none"});
  EXPECT_NE(outcome.status, 3) << outcome.err;
  EXPECT_TRUE(std::filesystem::is_symlink(path("link.stl")));
  EXPECT_GT(std::filesystem::file_size(file), 1000u);
}

TEST_F(EngraveCommandTest, WritesTheLongestNamesThatTheFileSystemTakes) {
  const std::string model = writeModel("plate.stl", shapes::plate({40, 40}, 5, 4, 4));
  const std::string name = std::string(251, 'x') + ".stl";
  const Outcome outcome =
      run({"engrave", model, "--text", "a", "-o", path(name), "--at", "0,0,5", "--size", "21", "--process", "none"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(readBack(name).has_value());
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
}

TEST_F(EngraveCommandTest, KeepsADistanceFromAShellThatMayBeACavity) {
  // The inner shell faces outwards, too, 2 mm below the surface.
  const Mesh model = shapes::together(shapes::box({60, 60, 20}), shapes::box({56, 56, 16}));
  const Outcome outcome = run({"engrave", writeModel("hollow.stl", model), "--text", "a", "-o", path("out.stl"), "--at",
                               "0,0,10", "--process", "none", "--quiet"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("pockets keep their distance from it either way"));
  const auto engraved = readBack("out.stl");
  ASSERT_TRUE(engraved.has_value());
  double deepest = 10;
  for (const Vec3& p : engraved->positions)
    if (p.z > 8.001) deepest = std::min(deepest, p.z);
  for (const Vec3& p : engraved->positions)
    EXPECT_FALSE(p.z < 8.79 && p.z > -9.9 && std::abs(p.x) < 27 && std::abs(p.y) < 27) << p.z;
  EXPECT_LT(deepest, 9.5) << "something is engraved";
}

TEST_F(EngraveCommandTest, SaysWhichOptionsHaveNoEffect) {
  const std::string model = writeModel("box.stl", shapes::box({40, 40, 8}));
  const Outcome slicer = run({"engrave", model, "--text", "x", "-o", path("x.stl"), "--for", "bambu"});
  EXPECT_EQ(slicer.status, 2);
  EXPECT_NE(slicer.err.find("--for is only for 3MF"), std::string::npos) << slicer.err;
  const Outcome painted =
      run({"engrave", model, "--text", "x", "-o", path("x.3mf"), "--at", "0,0,4", "--size", "25", "--max-size", "30",
           "--mark", "paint", "--solver", "fast", "--albedo", "0.8", "--quiet"});
  EXPECT_EQ(painted.status, 0) << painted.err;
  EXPECT_NE(painted.err.find("--solver has no effect"), std::string::npos) << painted.err;
  EXPECT_NE(painted.err.find("--max-size has no effect"), std::string::npos) << painted.err;
  EXPECT_EQ(painted.err.find("--albedo"), std::string::npos) << painted.err;
  const Outcome shadow = run({"engrave", model, "--text", "x", "-o", path("x.stl"), "--at", "0,0,800", "--size", "25",
                              "--mark-depth", "1", "--process", "none", "--quiet"});
  EXPECT_EQ(shadow.status, 0) << shadow.err;
  EXPECT_NE(shadow.err.find("--mark-depth has no effect"), std::string::npos) << shadow.err;
  EXPECT_NE(shadow.err.find("796 mm away from --at"), std::string::npos) << shadow.err;
  const Outcome near = run({"engrave", model, "--text", "x", "-o", path("x.stl"), "--at", "0,0,4.5", "--size", "25",
                            "--process", "none", "--quiet"});
  EXPECT_EQ(near.err, "");
}

TEST_F(EngraveCommandTest, NamesTheCharacterSetUnlessToldNotTo) {
  const std::string model = writeModel("box.stl", shapes::box({40, 40, 8}));
  const auto symbol = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments = {"engrave",   model,  "--at",        "0,0,4",    "--size",
                                          "25",        "-o",   path("x.stl"), "--report", path("x.json"),
                                          "--process", "none", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run(arguments).status, 0);
    EXPECT_EQ(
        run({"verify", path("x.stl"), "--report", path("x.json"), "--process", "none", "--quick", "--quiet"}).status,
        0);
    return nlohmann::json::parse(contentOf(path("x.json")))["symbol"];
  };
  EXPECT_EQ(symbol({"--text", "Z\u00FCrich"})["eci"], 26);
  EXPECT_FALSE(symbol({"--text", "Z\u00FCrich", "--eci", "never"}).contains("eci"));
  EXPECT_FALSE(symbol({"--text", "Zurich"}).contains("eci"));
}

TEST_F(EngraveCommandTest, NamesTheCharactersThatALabelCannotHave) {
  const std::string model = writeModel("plate.stl", shapes::plate({60, 60}, 5, 4, 4));
  const Outcome outcome =
      run({"engrave", model, "--text", "x", "--at", "0,0,5", "--label", "Teil 漢", "-o", path("out.stl"), "--quiet"});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("lacks these characters: \"漢\""), std::string::npos) << outcome.err;
}

TEST_F(EngraveCommandTest, UsesTheUnitOfA3mfByDefault) {
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

TEST_F(EngraveCommandTest, AcceptsEveryNamedDirectionAndSize) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(40, 4));
  const auto engraved = [&](const std::string& direction, const std::string& size) {
    const Outcome outcome =
        run({"engrave", model, "--text", "x", "--at", "0,0,40", "--direction", direction, "--size", size, "--max-size",
             "25", "-o", path("out.stl"), "--report", path("out.json"), "--quiet"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(contentOf(path("out.json")));
  };
  for (const std::string direction : {"mean-normal", "depth-balanced", "pca", "optimal", "largest"})
    EXPECT_EQ(engraved(direction, "25")["projection"]["method"], direction);
  const auto given = engraved("0.1,0,1", "best");
  EXPECT_EQ(given["projection"]["method"], "given");
  EXPECT_NEAR(given["projection"]["normal"][0].get<double>(), 0.1 / std::sqrt(1.01), 1e-9);
  EXPECT_EQ(given["size"]["mode"], "best");
  EXPECT_TRUE(given["size"].contains("rotationDeg"));
}

TEST_F(EngraveCommandTest, EncodesTheSymbolAsRequested) {
  const std::string model = writeModel("plate.stl", shapes::box({60, 60, 8}));
  const Outcome outcome = run({"engrave", model, "--at", "0,0,4", "--text", "QRELIEF", "--version", "3", "--mask", "5",
                               "-o", path("out.stl"), "--report", path("r.json")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto symbol = nlohmann::json::parse(contentOf(path("r.json")))["symbol"];
  EXPECT_EQ(symbol["ecc"], "H");
  EXPECT_EQ(symbol["mask"], 5);
  EXPECT_EQ(symbol["correctableCodewords"], 11);  // 3-H: two blocks with 22 check codewords each
}

TEST_F(EngraveCommandTest, ADirectionFromBehindHasNoSolution) {
  const Outcome outcome = run({"engrave", writeModel("ball.stl", shapes::icosphere(40, 3)), "--text", "x", "--at",
                               "0,0,40", "--direction", "0,0,-1", "-o", path("out.stl"), "--quiet"});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.err.find("faces away"), std::string::npos) << outcome.err;
}

TEST_F(EngraveCommandTest, WritesAnUnreadableCodeWithStatusOneAndTheReason) {
  // Pockets one layer deep in modules of 4 mm cast almost no shadow.
  const Outcome outcome = run({"engrave", writeModel("ball.stl", shapes::icosphere(100, 4)), "--text", "x", "--at",
                               "0,0,100", "--size", "70", "--max-depth", "0.1", "--pattern", "thin-plus",
                               "--finder-pattern", "as-modules", "-o", path("out.stl"), "--quiet"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find(fmt::format(" of {} tries", frontalTries())), std::string::npos) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(path("out.stl")));
}

TEST_F(EngraveCommandTest, UsesTheGivenLampsAndReportsThem) {
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

TEST_F(EngraveCommandTest, PresetsDifferInDepthAndExplicitSettingsOverrideThem) {
  const std::string model = writeModel("box.stl", shapes::box({40, 40, 8}));
  const auto meanDepth = [&](std::vector<std::string> options) {
    std::vector<std::string> words = {"engrave", model, "--text", "HELLO",         "--at",     "0,0,4",
                                      "--size",  "25",  "-o",     path("out.stl"), "--report", path("out.json"),
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
  EXPECT_EQ(meanDepth({"--preset", "robust", "--contrast", "0.25"}), balanced);
  EXPECT_EQ(run({"engrave", model, "--text", "HELLO", "--preset", "deep", "-o", path("out.stl")}).status, 2);
}

TEST_F(EngraveCommandTest, CarvesDeeperIfTheRequestedDepthDoesNotDecode) {
  const double slope = std::tan(40 * std::numbers::pi / 180);  // the model's own shade crosses the code
  const Mesh valley = shapes::plate({60, 60}, 60, 2, 2, [&](double x, double) { return slope * std::abs(x); });
  const std::string model = writeModel("valley.stl", valley);
  const auto engrave = [&](std::vector<std::string> options) {
    std::vector<std::string> words = {"engrave",        model,         "--text",      "HELLO",         "--at",
                                      "0,0,0",          "--direction", "0,0,1",       "--up",          "0,1,0",
                                      "--size",         "30",          "-o",          path("out.stl"), "--report",
                                      path("out.json"), "--quiet",     "--carve-for", "design"};
    words.insert(words.end(), options.begin(), options.end());
    return run(words);
  };
  const auto depth = [&] { return nlohmann::json::parse(contentOf(path("out.json")))["depth"]; };
  const Outcome shallow = engrave({"--preset", "shallow", "--keep-preset"});
  EXPECT_EQ(shallow.status, 1);
  EXPECT_NE(shallow.err.find(fmt::format("of {} tries on simulated pictures succeeded", frontalTries())),
            std::string::npos)
      << shallow.err;
  EXPECT_EQ(depth()["preset"], "shallow");
  EXPECT_EQ(engrave({"--contrast", "0.16"}).status, 1) << "what is said by itself is kept, too";
  EXPECT_FALSE(depth().contains("preset"));

  const Outcome deeper = engrave({"--preset", "shallow"});
  EXPECT_EQ(deeper.status, 0) << deeper.err;
  EXPECT_NE(deeper.out.find(": with shallow, the code or its print did not decode reliably"), std::string::npos)
      << deeper.out;
  EXPECT_EQ(depth()["askedPreset"], "shallow");
  EXPECT_NE(depth()["preset"], "shallow");
  EXPECT_GE(depth()["contrast"].get<double>(), 0.25);
}

TEST_F(EngraveCommandTest, EngravesTheBestSpotIfNoCentreIsGiven) {
  const std::string model = writeModel("cube.stl", shapes::box({60, 60, 60}));
  const Outcome outcome = run({"engrave", model, "--text", "HELLO", "-o", path("out.stl"), "--quiet"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.substr(0, 10), "placed at ");
  EXPECT_NE(outcome.out.find("reads as: HELLO"), std::string::npos);
}

}  // namespace
}  // namespace qrelief
