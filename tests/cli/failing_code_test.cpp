// SPDX-License-Identifier: GPL-3.0-or-later
// `qrelief engrave`: what it does and says where the code fails as requested.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/command_fixture.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

/// Tests of small or thin models whose code fails as requested.
class FailingCodeTest : public CommandTest {
 protected:
  Outcome engrave(const Mesh& mesh, std::vector<std::string> more, const std::string& output = "out.3mf") const {
    std::vector<std::string> all = {
        "engrave", writeModel("model.stl", mesh), "--text", text_, "-o", path(output), "--report", path("out.json"),
        "--quiet"};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }
  nlohmann::json report() const { return nlohmann::json::parse(contentOf(path("out.json"))); }
  std::string text_ = "https://example.com/a1";
  Mesh tag_ = shapes::box({25, 25, 3});
};

TEST_F(FailingCodeTest, ACodeThatDoesNotReadAsPrintedFailsAndIsWritten) {
  const Outcome outcome = engrave(tag_, {"--size", "free", "--label", "A-001", "--mark", "shadow"});
  EXPECT_EQ(outcome.status, 1) << outcome.out;
  EXPECT_NE(outcome.err.find("check failed: The code does not read as printed"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("may help: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("--size best"), std::string::npos) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(path("out.3mf")));
  const nlohmann::json verdict = report()["verification"]["verdict"];
  EXPECT_EQ(verdict["passed"], false);
  EXPECT_EQ(verdict["prints"]["passed"], false);
  const nlohmann::json tried = report()["tried"];
  ASSERT_EQ(tried.size(), 2u) << "only correction and capitals were left open";
  EXPECT_EQ(tried[1]["changes"], nlohmann::json({{{"setting", "ecc"}, {"value", "L"}},
                                                 {{"setting", "text"}, {"value", "HTTPS://EXAMPLE.COM/a1"}}}));
  EXPECT_EQ(tried[1]["passed"], false);
}

TEST_F(FailingCodeTest, TheLargestCodeIsMadeWithoutBeingAsked) {
  const Outcome outcome = engrave(tag_, {"--label", "A-001"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const nlohmann::json size = report()["size"];
  EXPECT_EQ(size["mode"], "best");
  EXPECT_GT(size["symbolMm"], 1.2 * size["guaranteedMm"].get<double>());
}

TEST_F(FailingCodeTest, WithLessErrorCorrectionASmallCodeHasLargerModules) {
  text_ = "thirty characters without link";  // version 3 at M, version 2 at L
  const Outcome outcome = engrave(shapes::box({18, 18, 4}), {"--mark", "shadow"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("engraved with --ecc L"), std::string::npos) << outcome.out;
  const nlohmann::json tried = report()["tried"];
  ASSERT_GE(tried.size(), 2u);
  EXPECT_EQ(tried[0]["passed"], false);
  EXPECT_EQ(tried[1]["passed"], true);
  EXPECT_EQ(tried[1]["changes"][0], (nlohmann::json{{"setting", "ecc"}, {"value", "L"}}));
}

TEST_F(FailingCodeTest, ThinWallsAreToldToTakeTheMarkThatWasTried) {
  const Outcome outcome = engrave(shapes::box({50, 50, 1}), {});
  EXPECT_EQ(outcome.status, 4) << outcome.out;
  EXPECT_EQ(outcome.err.find("--min-wall"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("hint: Use --mark "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("of 72 tries"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(path("out.3mf")));
}

}  // namespace
}  // namespace qrelief
