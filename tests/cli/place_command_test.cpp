// SPDX-License-Identifier: GPL-3.0-or-later
// `qrelief place`: the spots that it offers.
#include <nlohmann/json.hpp>

#include "cli/command_fixture.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using PlaceCommandTest = CommandTest;

TEST_F(PlaceCommandTest, OffersSpotsThatEngraveTakesAsPrinted) {
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

TEST_F(PlaceCommandTest, ExitsWithFourAndTheLargestSizeWhereNothingFits) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(20, 4));
  const Outcome outcome = run({"place", model, "--size", "50", "--quiet"});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.err.find("the largest found is "), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

}  // namespace
}  // namespace qrelief
