// SPDX-License-Identifier: GPL-3.0-or-later
// `qrelief info`: the facts it prints about a model, and its warnings.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/command_fixture.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using InfoCommandTest = CommandTest;

TEST_F(InfoCommandTest, ReportsSizeAndFindings) {
  Mesh open = shapes::box({40, 30, 20});
  open.triangles.resize(10);
  const Outcome outcome = run({"info", writeModel("open.stl", open), "--json", path("info.json")});
  EXPECT_EQ(outcome.status, 0);
  const auto info = nlohmann::json::parse(contentOf(path("info.json")));
  EXPECT_EQ(info["sizeMm"], nlohmann::json({40, 30, 20}));
  EXPECT_FALSE(info["engravable"].get<bool>());
  ASSERT_EQ(info["findings"].size(), 2u);
  EXPECT_EQ(info["findings"][0]["code"], "large-openings");
  EXPECT_EQ(info["findings"][1]["code"], "open-edges");
  EXPECT_EQ(info["findings"][1]["count"], 4);
  EXPECT_EQ(info["findings"][1]["values"]["count"], nlohmann::json({{"count", 4}}));
  EXPECT_EQ(info["findings"][1]["severity"], "blocking");
  EXPECT_NE(info["findings"][1]["message"].get<std::string>().find("4 open edges, one at ("), std::string::npos);
  EXPECT_NE(info["findings"][1]["hint"], "");
}

TEST_F(InfoCommandTest, DistinguishesWarningsFromErrorsAndGivesFileAndHint) {
  const std::string tiny = writeModel("tiny.stl", shapes::box({0.2, 0.1, 0.15}));
  const Outcome outcome = run({"engrave", tiny, "--text", "x", "--at", "0,0,0.075", "-o", path("out.stl"), "--quiet"});
  EXPECT_EQ(outcome.status, 4);
  const std::string helps = "--units m makes it 200 × 100 × 150 mm";
  const std::size_t warning = outcome.err.find("qrelief: warning: tiny.stl: The model is tiny: 0.2 × 0.1 × 0.15 mm\n");
  const std::size_t error = outcome.err.find("qrelief: error: tiny.stl: The model is too small for any code");
  ASSERT_NE(warning, std::string::npos) << outcome.err;
  ASSERT_NE(error, std::string::npos) << outcome.err;
  EXPECT_LT(outcome.err.find("  hint: If it should be larger, " + helps, warning), error) << outcome.err;
  EXPECT_NE(outcome.err.find("  hint: If it should be larger, " + helps, error), std::string::npos);
  EXPECT_NE(run({"place", tiny, "--quiet"}).err.find("  hint: If it should be larger, " + helps), std::string::npos);
  EXPECT_EQ(run({"engrave", tiny, "--text", "x", "--at", "0,0,0.075", "-o", path("out.stl"), "--contrast", "3"})
                .err.find("error: tiny.stl: The contrast"),
            std::string::npos);
}

TEST_F(InfoCommandTest, CallsAModelThatCrossesItselfClosedAndNoSolid) {
  const std::string model = writeModel("tangled.stl", shapes::tangledSphere());
  const std::string crossing = run({"info", model, "--no-repair", "crossings"}).out;
  EXPECT_NE(crossing.find("cross each other"), std::string::npos) << crossing;
  EXPECT_NE(crossing.find("closed, but crosses itself: ready to engrave"), std::string::npos) << crossing;
  EXPECT_EQ(crossing.find("closed solid"), std::string::npos) << crossing;
  EXPECT_NE(run({"info", model}).out.find("closed solid: ready to engrave"), std::string::npos) << "separated";
}

TEST_F(InfoCommandTest, NamesTheCrossingsOfOverlappingShells) {
  const Mesh post = shapes::translated(shapes::box({10, 10, 60}), {2, 0, 0});
  const std::string model = writeModel("post.stl", shapes::together(shapes::box({60, 60, 40}), post));
  const Outcome outcome = run({"info", model, "--json", path("info.json")});
  EXPECT_NE(outcome.out.find("pairs of triangles of separate shells cross or touch, the first near ("),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("closed solid: ready to engrave"), std::string::npos) << "slicers unite them";
  const auto info = nlohmann::json::parse(contentOf(path("info.json")));
  const auto& findings = info["findings"];
  const auto finding = std::find_if(findings.begin(), findings.end(),
                                    [](const auto& one) { return one["code"] == "overlapping-shells"; });
  ASSERT_NE(finding, findings.end());
  EXPECT_EQ((*finding)["severity"], "note");
  EXPECT_GE((*finding)["count"], 16) << "each of 8 triangles of walls crosses two faces";
  EXPECT_EQ(std::abs((*finding)["values"]["at"]["place"][2].get<double>()), 20) << "on the faces that the post crosses";
  EXPECT_EQ(run({"info", writeModel("box.stl", shapes::box({60, 60, 40}))}).out.find("separate shells"),
            std::string::npos);
}

TEST_F(InfoCommandTest, OptionsSwitchRepairsOff) {
  Mesh open = shapes::icosphere(40, 3);
  open.triangles.pop_back();
  const std::string model = writeModel("open.stl", open);
  EXPECT_NE(run({"info", model}).out.find("1 hole was filled"), std::string::npos);
  EXPECT_NE(run({"info", model, "--no-repair", "weld,holes"}).out.find("3 open edges"), std::string::npos);
  Mesh box = shapes::box({40, 40, 40});
  box.triangles.resize(10);
  const std::string large = writeModel("large.stl", box);
  EXPECT_NE(run({"info", large, "--max-hole", "0.1"}).out.find("too large to be filled"), std::string::npos);
  EXPECT_NE(run({"info", large, "--max-hole", "60"}).out.find("1 hole was filled"), std::string::npos);
  EXPECT_EQ(run({"info", model, "--max-hole", "wide"}).status, 2);
  EXPECT_EQ(run({"info", model, "--weld-tolerance", "-1"}).status, 2);
  EXPECT_EQ(run({"info", model, "--no-repair", "colours"}).status, 2);
  EXPECT_EQ(
      run({"engrave", model, "--text", "x", "--at", "0,0,40", "-o", path("out.stl"), "--no-repair", "all"}).status, 3);
}

}  // namespace
}  // namespace qrelief
