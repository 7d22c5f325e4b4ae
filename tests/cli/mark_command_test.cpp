// SPDX-License-Identifier: GPL-3.0-or-later
// `qrelief engrave --mark`: codes in a second colour, and their files.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/command_fixture.h"
#include "io/three_mf/write_3mf.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using MarkCommandTest = CommandTest;

/// Returns the outward volume of the soup's triangles from `first` up to `end`.
double volumeOf(const PolygonSoup& soup, std::size_t first, std::size_t end) {
  double sixfold = 0;
  for (std::size_t t = first; t < end; ++t) {
    const auto& [a, b, c] = soup.triangles[t];
    sixfold += glm::dot(soup.positions[a], glm::cross(soup.positions[b], soup.positions[c]));
  }
  return sixfold / 6;
}

TEST_F(MarkCommandTest, TheInlayFillsThePocketsAndOtherObjectsStayUnchanged) {
  const std::vector<ModelObject> objects = {
      {"ball", {{"", shapes::icosphere(40, 4), {}}}},
      {"cube", {{"", shapes::translated(shapes::box({5, 6, 7}), {100, 0, 0}), {}}}}};
  const std::string model = writeBytes("two.3mf", *write3mf(objects, {}));
  const Outcome outcome = run({"engrave", model, "--text", "x", "--at", "0,0,40", "--size", "25", "--mark", "inlay",
                               "--process", "none", "-o", path("inlaid.3mf"), "--quiet"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto inlaid = readBack("inlaid.3mf"), original = readBack("two.3mf");
  ASSERT_TRUE(inlaid && original);
  ASSERT_EQ(inlaid->parts.size(), 2u);
  EXPECT_EQ(inlaid->parts[0].name, "ball");
  EXPECT_EQ(inlaid->parts[1].name, "cube");
  const std::size_t cube = inlaid->parts[1].firstTriangle, cubeBefore = original->parts[1].firstTriangle;
  ASSERT_EQ(inlaid->triangles.size(), cube + 12);
  for (std::size_t t = 0; t < 12; ++t)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(inlaid->positions[inlaid->triangles[cube + t][k]],
                original->positions[original->triangles[cubeBefore + t][k]]);
  // The inlay is a body of its own, after the body that it fills.
  std::size_t first = 0;
  while (inlaid->bodyOf.at(first) == inlaid->bodyOf.at(0)) ++first;
  const double body = volumeOf(*inlaid, 0, first), inlay = volumeOf(*inlaid, first, cube);
  EXPECT_GT(inlay, 50);
  EXPECT_NEAR((body + inlay) / volumeOf(*original, 0, cubeBefore), 1, 1e-6);
}

TEST_F(MarkCommandTest, ColourNeedsAFormatWithColours) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(40, 3));
  for (const auto& [mark, output] :
       {std::pair("inlay", "out.ply"), std::pair("paint", "out.ply"), std::pair("paint", "out.stl")}) {
    const Outcome outcome =
        run({"engrave", model, "--text", "x", "--at", "0,0,40", "-o", path(output), "--mark", mark, "--quiet"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(std::string("--mark ") + mark + " needs a format with two colours"), std::string::npos)
        << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(path(output)));
  }
}

TEST_F(MarkCommandTest, AnInlayHasAFileOfItsOwnInStl) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(40, 3));
  const Outcome outcome = run({"engrave", model, "--text", "x", "--at", "0,0,40", "-o", path("out.stl"), "--mark",
                               "inlay", "--process", "none", "--quiet"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(path("out.stl")));
  EXPECT_TRUE(std::filesystem::exists(path("out-2.stl")));
}

TEST_F(MarkCommandTest, AnOpenMarkTakesAnInlayWhereWallsAreTooThinForAShadow) {
  const std::string model = writeModel("plate.stl", shapes::plate({60, 60}, 1.05, 4, 4));
  const Outcome outcome =
      run({"engrave", model, "--text", "x", "--at", "0,0,1.05", "--up", "0,1,0", "--size", "25", "--mark", "auto",
           "--build-up", "code-up", "--quiet", "-o", path("out.3mf"), "--report", path("out.json")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto report = nlohmann::json::parse(contentOf(path("out.json")));
  EXPECT_NE(report["mark"], "shadow");
  EXPECT_NE(outcome.out.find("made as " + report["mark"].get<std::string>() + ": as a shadow,"), std::string::npos)
      << outcome.out;
  EXPECT_EQ(report["verification"]["verdict"]["prints"]["level"], "good");
  const Outcome inStl =
      run({"engrave", model, "--text", "x", "--at", "0,0,1.05", "--up", "0,1,0", "--size", "25", "--mark", "auto",
           "--build-up", "code-up", "--quiet", "-o", path("out.stl"), "--report", path("stl.json")});
  EXPECT_EQ(inStl.status, 0) << inStl.err;
  const auto inlaid = nlohmann::json::parse(contentOf(path("stl.json")));
  EXPECT_EQ(inlaid["mark"], "inlay") << "STL holds no paint";
  EXPECT_TRUE(std::filesystem::exists(path("out-2.stl")));
}

TEST_F(MarkCommandTest, AnInlayIsWrittenReportedAndVerified) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(40, 5));
  const Outcome engraved =
      run({"engrave", model, "--text", "HELLO", "--at", "0,0,40", "--size", "25", "--mark", "inlay", "--mark-depth",
           "0.5", "-o", path("ball.3mf"), "--report", path("ball.json"), "--quiet"});
  EXPECT_EQ(engraved.status, 0) << engraved.err;
  EXPECT_NE(engraved.out.find("an inlay 0.5 mm deep"), std::string::npos) << engraved.out;
  const Outcome verified = run({"verify", path("ball.3mf"), "--report", path("ball.json"), "--quick", "--quiet"});
  EXPECT_EQ(verified.status, 0) << verified.err << verified.out;
  EXPECT_NE(verified.out.find("a closed solid"), std::string::npos) << verified.out;
}

}  // namespace
}  // namespace qrelief
