// SPDX-License-Identifier: GPL-3.0-or-later
// `qrelief place`: the spots it offers.
#include <nlohmann/json.hpp>

#include "cli/command_fixture.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using PlaceCommandTest = CommandTest;

TEST_F(PlaceCommandTest, ListsSpotsThatEngraveAccepts) {
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

TEST_F(PlaceCommandTest, ReportsSpotsTooSmallForTheNozzleAndTheSizeThatWouldDo) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(20, 4));
  const auto place = [&](std::vector<std::string> more) {
    std::vector<std::string> all = {"place", model, "--count", "2", "--json", path("spots.json"), "--quiet"};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  };
  const Outcome fine = place({});
  ASSERT_EQ(fine.status, 0) << fine.err;
  EXPECT_EQ(fine.out.find("nozzle"), std::string::npos);
  const Outcome coarse = place({"--nozzle", "1.5"});  // 21 modules of 2.25 mm
  ASSERT_EQ(coarse.status, 0) << coarse.err;
  EXPECT_NE(coarse.out.find("The code is too small for a nozzle of 1.5 mm"), std::string::npos) << coarse.out;
  EXPECT_NE(coarse.out.find("with room for 47.3 mm"), std::string::npos) << coarse.out;
  const auto json = nlohmann::json::parse(contentOf(path("spots.json")));
  EXPECT_NEAR(json["parameters"]["leastPrintableMm"], 47.25, 1e-9);
  for (const auto& spot : json["spots"]) EXPECT_EQ(spot["prints"], false);
  const Outcome impossible = place({"--nozzle", "0.2", "--layer", "0.5"});
  EXPECT_EQ(impossible.status, 2);
  EXPECT_NE(impossible.err.find("A nozzle of 0.2 mm cannot lay layers of 0.5 mm"), std::string::npos) << impossible.err;
}

TEST_F(PlaceCommandTest, LeavesRoomForLabelAndFrame) {
  const std::string model = writeModel("plate.stl", shapes::plate({40, 40}, 5, 4, 4));
  const auto largestWith = [&](std::vector<std::string> more) {
    std::vector<std::string> all = {"place",   model,  "--count", "1",      "--text", "x", "--json", path("spots.json"),
                                    "--quiet", "--up", "0,1,0",   "--size", "best"};
    all.insert(all.end(), more.begin(), more.end());
    EXPECT_EQ(run(all).status, 0);
    return nlohmann::json::parse(contentOf(path("spots.json")))["spots"][0]["largestMm"].get<double>();
  };
  // A code of 21 modules takes 29 with its quiet zone, and 34 with a frame: on each side half a module of gap, the line
  // of one, and one of material.
  EXPECT_NEAR(largestWith({"--frame", "square"}) / largestWith({}), 29.0 / 34.0, 0.06);
  EXPECT_LT(largestWith({"--frame", "square", "--label", "AB"}), 0.95 * largestWith({"--frame", "square"}));
}

TEST_F(PlaceCommandTest, ReportsSpotsThatFaceDownInTheRequestedPose) {
  const std::string model = writeModel("box.stl", shapes::box({60, 60, 12}));
  const auto place = [&](const std::string& buildUp) {
    return run({"place", model, "--size", "30", "--build-up=" + buildUp, "--json", path("spots.json"), "--quiet"}).out;
  };
  EXPECT_NE(place("as-modelled").find("The mark faces down"), std::string::npos);
  EXPECT_EQ(place("code-up").find("The mark faces down"), std::string::npos);
  place("0,0,-1");
  const auto json = nlohmann::json::parse(contentOf(path("spots.json")));
  EXPECT_LT(json["spots"].front()["direction"][2].get<double>(), -0.9);
  EXPECT_EQ(json["spots"].back()["facesDown"], true);
}

TEST_F(PlaceCommandTest, SuggestsAUnitInWhichEngravingSucceeds) {
  const std::string inches = writeModel("bracket.stl", shapes::box({12, 3, 2}));
  const Outcome place = run({"place", inches, "--quiet"});
  EXPECT_EQ(place.status, 4);
  EXPECT_NE(place.err.find("--units in makes it 305 × 76.2 × 50.8 mm"), std::string::npos) << place.err;
  const std::vector<std::string> engrave = {"engrave", inches, "--text", "x", "-o", path("out.stl"), "--quiet"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = engrave;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  };
  const Outcome here = with({"--at", "0,0,1"});
  EXPECT_EQ(here.status, 4);
  EXPECT_NE(here.err.find("--units in makes it"), std::string::npos) << here.err;
  EXPECT_EQ(with({"--units", "in", "--process", "none"}).status, 0);
  EXPECT_EQ(with({"--units", "um"}).status, 4);
}

TEST_F(PlaceCommandTest, ExitsWithFourAndTheLargestSizeIfNothingFits) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(20, 4));
  const Outcome outcome = run({"place", model, "--size", "50", "--quiet"});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.err.find("the largest size found is "), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

}  // namespace
}  // namespace qrelief
