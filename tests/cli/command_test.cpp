// SPDX-License-Identifier: GPL-3.0-or-later
// The command as scripts see it: exit statuses, usage, and what goes to stdout and stderr.
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "cli/command_fixture.h"
#include "messages/option_texts.h"
#include "support/paths.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

TEST_F(CommandTest, QuietPrintsNoProgress) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(40, 4));
  const Outcome outcome =
      run({"engrave", model, "--text", "x", "--at", "0,0,40", "--size", "25", "-o", path("out.stl"), "--quiet"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
}

TEST_F(CommandTest, BadUsageIsStatusTwo) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(40, 3));
  EXPECT_EQ(run({}).status, 2);
  const Outcome unknown = run({"frobnicate", model});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("no command frobnicate"), std::string::npos) << unknown.err;
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
  for (const char* centre : {"nan,0,40", "0,inf,40", "0,0,1e300", "0,0,top"}) {
    const Outcome outcome = run({"engrave", model, "--text", "x", "--at", centre, "-o", path("out.stl")});
    EXPECT_EQ(outcome.status, 2) << centre;
    EXPECT_NE(outcome.err.find("--at"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(run({"info", model, "--units", "cm", "--scale", "3"}).status, 2) << "two units";
  for (const char* direction : {"upwards", "1,2", "1,2,x", "0,0,0", "1,2,3,4"})
    EXPECT_EQ(run({"engrave", model, "--text", "x", "--at", "0,0,40", "-o", path("out.stl"), "--direction", direction})
                  .status,
              2)
        << direction;
  EXPECT_FALSE(std::filesystem::exists(path("out.stl")));
}

TEST_F(CommandTest, EngraveHasAFlagAndHelpForEverySetting) {
  const std::string help = run({"engrave", "--help"}).out;
  for (const Setting& setting : settings()) {
    const OptionTexts texts = optionTexts(setting);
    EXPECT_NE(help.find("\n  " + texts.flag + " "), std::string::npos) << texts.flag;
    EXPECT_NE(help.find(texts.help), std::string::npos) << texts.flag;
  }
}

TEST_F(CommandTest, TheDocumentationNamesEveryFlagOfTheHelp) {
  const std::filesystem::path docs = sourceFolder() / "docs";
  const std::string documents = contentOf(docs / "command-line.md") + contentOf(docs / "options.md");
  const std::regex flag("\n  (?:-\\w,)?(--?[\\w-]+)");
  std::size_t flags = 0;
  for (const char* command : {"engrave", "batch", "info", "place", "verify"}) {
    const std::string help = run({command, "--help"}).out;
    for (std::sregex_iterator at(help.begin(), help.end(), flag), end; at != end; ++at, ++flags)
      EXPECT_TRUE((*at)[1] == "-h" || (*at)[1] == "--help" || documents.find("`" + (*at)[1].str()) != std::string::npos)
          << command << " " << (*at)[1];
  }
  EXPECT_GT(flags, settings().size());
}

TEST_F(CommandTest, RefusesANumberOutOfRangeByFlagBeforeReadingTheModel) {
  for (const Setting& setting : settings()) {
    if (!setting.takesNumber()) continue;
    const std::string flag = optionTexts(setting).flag;
    for (const double value : {setting.min - 1, 2 * setting.max + 1}) {
      const Outcome outcome =
          run({"engrave", path("missing.stl"), "--text", "x", "-o", path("out.stl"), flag, fmt::format("{}", value)});
      EXPECT_EQ(outcome.status, 2) << flag;
      EXPECT_NE(outcome.err.find("qrelief: error: " + flag + " is "), std::string::npos) << outcome.err;
      EXPECT_NE(outcome.err.find("hint: Choose from"), std::string::npos) << outcome.err;
    }
  }
}

TEST_F(CommandTest, RefusesAnUnknownChoiceAndListsTheChoices) {
  const Outcome outcome =
      run({"engrave", path("missing.stl"), "--text", "x", "-o", path("out.stl"), "--pattern", "dots"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("--pattern is \"dots\""), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("none, square, thin-plus, diamond, thick-plus"), std::string::npos) << outcome.err;
}

TEST_F(CommandTest, BadInputIsStatusThreeWithAHint) {
  EXPECT_EQ(run({"info", path("missing.stl")}).status, 3);
  writeBytes("empty.stl", {});
  EXPECT_EQ(run({"info", path("empty.stl")}).status, 3);

  Mesh open = shapes::box({40, 40, 40});
  open.triangles.resize(10);
  const Outcome outcome =
      run({"engrave", writeModel("open.stl", open), "--text", "x", "--at", "0,0,20", "-o", path("out.stl")});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("hint"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(path("out.stl")));
}

TEST_F(CommandTest, NoSolutionIsStatusFour) {
  const Outcome outcome = run({"engrave", writeModel("ball.stl", shapes::icosphere(20, 4)), "--text", "x", "--at",
                               "0,0,20", "--size", "60", "-o", path("out.stl")});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.err.find("There is no room here for a code of 60 mm"), std::string::npos) << outcome.err;
}

TEST_F(CommandTest, AnUnwritableOutputIsAnErrorAndLeavesNoFile) {
  const Outcome outcome = run({"engrave", writeModel("ball.stl", shapes::icosphere(40, 4)), "--text", "x", "--at",
                               "0,0,40", "--size", "25", "-o", path("no_such_folder/out.stl"), "--quiet"});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("no_such_folder"), std::string::npos);
}

TEST_F(CommandTest, VersionAndHelpAreStatusZero) {
  EXPECT_EQ(run({"--version"}).status, 0);
  EXPECT_EQ(run({"--help"}).status, 0);
  EXPECT_EQ(run({"engrave", "--help"}).status, 0);
}

TEST_F(CommandTest, ResultsThatCannotBePrintedAreNoSuccess) {
  const std::string model = writeModel("box.stl", shapes::box({40, 40, 40}));
  const Outcome outcome = run({"info", model}, ">/dev/full");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("The output cannot be written: No space left"), std::string::npos) << outcome.err;
  EXPECT_EQ(run({"info", model}).status, 0);
}

TEST_F(CommandTest, ADashIsStandardOutputForJsonAndStandardInputForInputs) {
  const std::string model = writeModel("plate.stl", shapes::plate({40, 40}, 5, 4, 4));
  const auto jsonOf = [&](const std::vector<std::string>& arguments, const std::string& redirections = {}) {
    const Outcome outcome = run(arguments, redirections);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("mm"), std::string::npos) << "what it prints otherwise: " << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out, nullptr, false);
    EXPECT_TRUE(json.contains("qrelief") || json.contains("file")) << outcome.out;
    return outcome.out;
  };
  jsonOf({"info", model, "--json", "-"});
  jsonOf({"info", "-", "--json", "-"}, "<'" + model + "'");
  jsonOf({"place", model, "--size", "21", "--count", "1", "--json", "-", "--quiet"});
  std::ofstream(path("r.json")) << jsonOf({"engrave", model, "--text", "a", "--at", "0,0,5", "--size", "21",
                                           "--process", "none", "-o", path("a.stl"), "--report", "-", "--quiet"});
  jsonOf({"verify", path("a.stl"), "--report", "-", "--json", "-", "--process", "none", "--quick", "--quiet"},
         "<'" + path("r.json") + "'");
  EXPECT_FALSE(std::filesystem::exists("-"));
}

TEST_F(CommandTest, ADashNamesNoFileOrFolder) {
  const std::string model = writeModel("plate.stl", shapes::plate({40, 40}, 5, 4, 4));
  for (const std::vector<std::string>& given :
       std::vector<std::vector<std::string>>{{"engrave", model, "--text", "a", "-o", "-"},
                                             {"engrave", model, "--text", "a", "-o", path("a.stl"), "--preview", "-"},
                                             {"engrave", model, "--text", "a", "-o", path("a.stl"), "--maps", "-"},
                                             {"batch", model, "--count", "1", "--text", "{n}", "-o", "-"}}) {
    const Outcome outcome = run(given);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("choose a "), std::string::npos) << outcome.err;
  }
  EXPECT_FALSE(std::filesystem::exists("-"));
}

TEST_F(CommandTest, ClosedStandardStreamsEndUpInNoFile) {
  const std::string model = writeModel("plate.stl", shapes::plate({40, 40}, 5, 4, 4));
  const auto statusOf = [&](std::vector<std::string> arguments) {
    for (const char* cheap : {"--at", "0,0,5", "--size", "21", "--process", "none"}) arguments.emplace_back(cheap);
    return run(arguments, "<&- >&- 2>&-").status;
  };
  EXPECT_EQ(statusOf({"engrave", model, "--text", "a", "-o", path("one.stl")}), 0);
  EXPECT_TRUE(readBack("one.stl").has_value());
  EXPECT_EQ(statusOf({"batch", model, "--count", "2", "--text", "a{n}", "-o", path("out")}), 0);
  std::istringstream lines(contentOf(path("out/manifest.jsonl")));
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) EXPECT_TRUE(line.starts_with("{\"number\"")) << line;
  EXPECT_EQ(count, 2);
}

}  // namespace
}  // namespace qrelief
