// SPDX-License-Identifier: GPL-3.0-or-later
// `qrelief verify`: its verdict on a file.
#include <fstream>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "cli/command_fixture.h"
#include "support/shapes.h"
#include "support/zip_file.h"

namespace qrelief {
namespace {

using VerifyCommandTest = CommandTest;

TEST_F(VerifyCommandTest, PassesWhatEngraveWroteAndReportsProblemsOfOtherModels) {
  const std::string model = writeModel("box.stl", shapes::box({40, 40, 8}));
  ASSERT_EQ(run({"engrave", model, "--text", "HELLO", "--at", "0,0,4", "--size", "25.2", "-o", path("out.3mf"),
                 "--report", path("out.json"), "--carve-for", "design", "--quiet"})
                .status,
            0);
  const Outcome good = run({"verify", path("out.3mf"), "--report", path("out.json"), "--json", path("verified.json"),
                            "--nozzle", "1.2", "--quick", "--quiet"});
  EXPECT_EQ(good.status, 0) << good.err;
  EXPECT_NE(good.out.find("reads as: HELLO"), std::string::npos) << good.out;
  EXPECT_NE(good.out.find("With a 1.2 mm nozzle, choose modules of 1.8 mm or more"), std::string::npos) << good.out;
  EXPECT_EQ(good.err, "");
  const auto json = nlohmann::json::parse(contentOf(path("verified.json")));
  EXPECT_EQ(json["verified"], true);
  EXPECT_EQ(json["input"]["format"], "3MF");

  EXPECT_EQ(json["verification"]["printed"]["process"], "fdm-0.4/0.2");
  EXPECT_EQ(json["verification"]["printed"]["tries"], frontalTries());

  const Outcome wall = run({"verify", path("out.3mf"), "--report", path("out.json"), "--json", path("wall.json"),
                            "--process", "fdm-0.4/0.12", "--build-up", "0,1,0", "--quick", "--quiet"});
  EXPECT_EQ(wall.status, 0) << wall.err;
  EXPECT_NE(wall.out.find("upright (0.4 mm nozzle, 0.12 mm layers)"), std::string::npos) << wall.out;
  EXPECT_EQ(nlohmann::json::parse(contentOf(path("wall.json")))["verification"]["printed"]["facingDeg"], 90);
  const Outcome unprinted = run({"verify", path("out.3mf"), "--report", path("out.json"), "--json",
                                 path("unprinted.json"), "--process", "none", "--quick", "--quiet"});
  EXPECT_EQ(unprinted.out.find("printed"), std::string::npos) << unprinted.out;
  EXPECT_TRUE(nlohmann::json::parse(contentOf(path("unprinted.json")))["verification"]["printed"].is_null());
  for (const std::vector<std::string>& impossible : std::vector<std::vector<std::string>>{
           {"--build-up", "0,0,0"}, {"--layer", "0.5"}, {"--line-width", "0.2"}, {"--process", "clay"}}) {
    std::vector<std::string> arguments = {"verify",         path("out.3mf"), "--report",
                                          path("out.json"), "--quick",       "--quiet"};
    arguments.insert(arguments.end(), impossible.begin(), impossible.end());
    const Outcome refused = run(arguments);
    EXPECT_EQ(refused.status, 2) << impossible.front() << ": " << refused.err;
    EXPECT_NE(refused.err, "");
  }

  const Outcome plain = run({"verify", model, "--report", path("out.json"), "--quick", "--quiet"});
  EXPECT_EQ(plain.status, 1);
  EXPECT_NE(plain.err.find("No engraved modules of this code"), std::string::npos) << plain.err;
  EXPECT_EQ(plain.out.find("printed"), std::string::npos) << plain.out;
}

TEST_F(VerifyCommandTest, FindsAnotherProcessOrPoseThatWouldDecode) {
  const std::string model = writeModel("box.stl", shapes::box({20, 20, 8}));
  const auto engrave = [&](const std::string& process) {
    return run({"engrave", model, "--text", "HELLO", "--at", "0,0,4", "--size", "10.5", "--process", process, "-o",
                path("out.stl"), "--report", path("out.json"), "--try-prints", "--quiet"});
  };
  const auto expectWays = [](const Outcome& outcome, const char* heading, const char* reads) {
    for (const char* way : {heading, "--build-up code-upright: ", "--process fdm-0.4/0.2: ", "--process fdm-0.4/0.12: ",
                            "--process fdm-0.25/0.1: ", "--process resin-0.05: ", reads})
      EXPECT_NE(outcome.out.find(way), std::string::npos) << way << "\n" << outcome.out;
  };
  const Outcome coarse = engrave("fdm-0.6/0.3");  // modules narrower than the nozzle
  EXPECT_EQ(coarse.status, 0) << coarse.err;
  expectWays(coarse, "engraved for other ways", "--process resin-0.05: Reads as printed");
  const Outcome same = run({"verify", path("out.stl"), "--report", path("out.json"), "--process", "fdm-0.6/0.3",
                            "--try-prints", "--quick", "--quiet"});
  expectWays(same, "this model, printed in other ways", "");
  const Outcome fine = engrave("resin-0.05");
  EXPECT_EQ(fine.out.find("other"), std::string::npos) << fine.out;
}

TEST_F(VerifyCommandTest, RefusesFlagsThatTheReportGives) {
  for (const std::vector<std::string>& given : std::vector<std::vector<std::string>>{
           {"--text", "OTHER"}, {"--at", "0,0,4"}, {"--size", "20"}, {"--ecc", "H"}, {"--mark", "paint"}}) {
    std::vector<std::string> arguments = {"verify", path("x.stl"), "--report", path("x.json")};
    arguments.insert(arguments.end(), given.begin(), given.end());
    const Outcome refused = run(arguments);
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find(given[0] + " has no effect with --report"), std::string::npos) << refused.err;
  }
  EXPECT_EQ(run({"verify", path("x.stl"), "--report", path("x.json"), "--json", path("x.json")}).status, 2);
}

TEST_F(VerifyCommandTest, NeedsThePlacementOfTheCode) {
  const std::string model = writeModel("box.stl", shapes::box({40, 40, 8}));
  const Outcome nowhere = run({"verify", model, "--text", "HELLO", "--quiet"});
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_NE(nowhere.err.find("--at"), std::string::npos) << nowhere.err;
  const Outcome missing = run({"verify", model, "--report", path("missing.json"), "--quiet"});
  EXPECT_EQ(missing.status, 3);
  EXPECT_THAT(missing.err, testing::HasSubstr("missing.json: It cannot be opened"));
  std::ofstream(path("broken.json")) << "{}";
  const Outcome broken = run({"verify", model, "--report", path("broken.json"), "--quiet"});
  EXPECT_EQ(broken.status, 3);
  EXPECT_NE(broken.err.find("text"), std::string::npos) << broken.err;
}

TEST_F(VerifyCommandTest, FindsAnInlayOnOneOfTwoEqualItems) {
  const std::string model =
      writeBytes("two.3mf", zip_file::threeMf(zip_file::modelPart(
                                zip_file::boxObject(1, 40, 40, 5),
                                R"(<item objectid="1"/><item objectid="1" transform="1 0 0 0 1 0 0 0 1 50 0 0"/>)")));
  for (const std::string at : {"20,20,5", "70,20,5"}) {
    const Outcome made = run({"engrave", model, "--text", "HELLO", "--at", at, "--mark", "inlay", "-o", path("out.3mf"),
                              "--report", path("out.json"), "--quiet"});
    ASSERT_EQ(made.status, 0) << made.err;
    const Outcome read = run({"verify", path("out.3mf"), "--report", path("out.json"), "--quick", "--quiet"});
    EXPECT_EQ(read.status, 0) << at << read.out << read.err;
  }
}

TEST_F(VerifyCommandTest, ReadsAnInlayInABodyThatLiesOnAnother) {
  const std::string model =
      writeBytes("two.3mf", zip_file::threeMf(zip_file::modelPart(
                                zip_file::boxObject(1, 40, 40, 5) + zip_file::boxObject(2, 40, 40, 3),
                                R"(<item objectid="1"/><item objectid="2" transform="1 0 0 0 1 0 0 0 1 0 0 5"/>)")));
  for (const std::string out : {"out.3mf", "out.stl"}) {
    const Outcome made = run({"engrave", model, "--text", "HELLO", "--at", "20,20,8", "--mark", "inlay", "-o",
                              path(out), "--report", path("out.json"), "--quiet"});
    ASSERT_EQ(made.status, 0) << made.err;
    const Outcome read = run({"verify", path(out), "--report", path("out.json"), "--quick", "--quiet"});
    EXPECT_EQ(read.status, 0) << out << read.out << read.err;
    EXPECT_NE(read.out.find("a closed solid"), std::string::npos) << out << read.out;
  }
}

}  // namespace
}  // namespace qrelief
