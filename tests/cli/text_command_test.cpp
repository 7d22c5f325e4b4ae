// SPDX-License-Identifier: GPL-3.0-or-later
// `qrelief engrave --content text`: a text in place of a code.
#include <nlohmann/json.hpp>

#include "cli/command_fixture.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using TextCommandTest = CommandTest;

TEST_F(TextCommandTest, MakesATextAloneInLines) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(40, 4));
  const auto engrave = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = {"engrave", model, "--content", "text", "--quiet", "--report", path("out.json")};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  };
  const Outcome made = engrave({"--text", "Rev B\n2026", "-o", path("out.stl")});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.out.find("text, 40 mm across, 0.4 mm deep"), std::string::npos) << made.out;
  EXPECT_NE(made.out.find("A person can read it: capitals "), std::string::npos) << made.out;
  EXPECT_EQ(made.out.find("reads as"), std::string::npos) << made.out;
  EXPECT_TRUE(nlohmann::json::parse(contentOf(path("out.json")))["verification"]["decoded"].is_null());
  const Outcome verified = run({"verify", path("out.stl"), "--report", path("out.json"), "--quiet"});
  EXPECT_EQ(verified.status, 0) << verified.err;
  EXPECT_NE(verified.out.find("a closed solid"), std::string::npos) << verified.out;
  EXPECT_NE(verified.out.find("nothing to decode"), std::string::npos) << verified.out;
  Mesh open = shapes::icosphere(40, 4);
  open.triangles.pop_back();
  EXPECT_EQ(run({"verify", writeModel("open.stl", open), "--report", path("out.json"), "--quiet"}).status, 1);

  const Outcome inColour = engrave({"--text", "Rev B", "--mark", "inlay", "-o", path("out.3mf")});
  EXPECT_EQ(inColour.status, 0) << inColour.err;
  const Outcome fine = engrave({"--text", std::string(40, 'm'), "--max-size", "20", "-o", path("out.stl")});
  EXPECT_EQ(fine.status, 1) << fine.out;
  EXPECT_NE(fine.err.find("the finest that prints is"), std::string::npos) << fine.err;
  const Outcome labelled = engrave({"--text", "Rev B", "--label", "No. 7", "-o", path("out.stl")});
  EXPECT_EQ(labelled.status, 2);
  EXPECT_NE(labelled.err.find("--label does not go with --content text"), std::string::npos) << labelled.err;
  EXPECT_EQ(engrave({"--text", "Rev B", "--preview", path("out.png"), "-o", path("out.stl")}).status, 2);
  EXPECT_EQ(engrave({"--text", "Rev B", "--maps", path("out.npz"), "-o", path("out.stl")}).status, 2);
  const Outcome unused =
      engrave({"--text", "Rev B", "--at", "0,0,40", "--ecc", "H", "--albedo", "0.8", "-o", path("out.stl")});
  EXPECT_NE(unused.err.find("--ecc has no effect"), std::string::npos) << unused.err;
  EXPECT_NE(unused.err.find("--albedo has no effect"), std::string::npos) << unused.err;
}

TEST_F(TextCommandTest, AnOpenMarkPaintsATextWhereWallsTakeNoLetters) {
  const std::string model = writeModel("plate.stl", shapes::plate({60, 60}, 0.9, 4, 4));
  const auto engrave = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = {"engrave", model, "--content", "text", "--text", "Hello", "--quiet"};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  };
  const std::vector<std::string> at = {"--at", "0,0,0.9", "-o", path("out.stl")};
  for (const auto& where : {at, std::vector<std::string>{"-o", path("out.stl")}}) {
    const Outcome shadow = engrave(where);
    EXPECT_EQ(shadow.status, 4) << shadow.out;
    EXPECT_NE(shadow.err.find("in a .3mf file"), std::string::npos) << shadow.err;
    EXPECT_EQ(shadow.err.find("code"), std::string::npos) << shadow.err;
  }
  const Outcome open = engrave({"--mark", "auto", "-o", path("out.3mf"), "--report", path("out.json")});
  EXPECT_EQ(open.status, 0) << open.err;
  EXPECT_NE(open.out.find("made as paint: as a shadow, it could not be carved"), std::string::npos) << open.out;
  EXPECT_EQ(nlohmann::json::parse(contentOf(path("out.json")))["mark"], "paint");
  EXPECT_EQ(engrave({"--mark", "paint", "--at", "0,0,0.9", "-o", path("out.3mf")}).status, 0);
}

}  // namespace
}  // namespace qrelief
