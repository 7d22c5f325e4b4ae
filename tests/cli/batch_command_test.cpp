// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <sys/stat.h>

#include "cli/command_fixture.h"
#include "math/box.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using Json = nlohmann::json;

class BatchCommandTest : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    model_ = writeModel("plate.stl", shapes::plate({40, 40}, 5, 4, 4));
  }

  std::string writeText(const std::string& name, const std::string& text) const {
    return writeBytes(name, std::vector<std::uint8_t>(text.begin(), text.end()));
  }

  /// Returns arguments for the cheapest codes: small, and without a print simulation.
  std::vector<std::string> arguments(std::vector<std::string> more, const std::string& folder = "out") const {
    std::vector<std::string> all = {"batch",  model_, "-o",        path(folder), "--at",   "0,0,5",
                                    "--size", "21",   "--process", "none",       "--quiet"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  std::vector<std::string> filesIn(const std::string& folder) const {
    std::vector<std::string> names;
    if (fs::exists(path(folder)))
      for (const auto& entry : fs::directory_iterator(path(folder))) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

  std::vector<Json> linesOf(const std::string& text) const {
    std::vector<Json> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(Json::parse(line));
    return lines;
  }
  std::vector<Json> manifest(const std::string& folder = "out") const {
    return linesOf(contentOf(path(folder + "/manifest.jsonl")));
  }

  std::string model_;
};

TEST_F(BatchCommandTest, CarvesOneModelPerRowAndReportsEachResult) {
  const std::string list = writeText("l.csv", "id;text\nA 1;first\nB2;\"second; quoted\"\n");
  const Outcome outcome = run(arguments({"--list", list, "--reports"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("2 rows: 2 done, 0 failed, 0 missing"));
  EXPECT_EQ(filesIn("out"), (std::vector<std::string>{"A 1.stl", "A 1.stl.json", "B2.stl", "B2.stl.json",
                                                      "manifest.csv", "manifest.jsonl"}));
  const std::vector<Json> entries = manifest();
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[1]["id"], "B2");
  EXPECT_EQ(entries[1]["text"], "second; quoted");
  EXPECT_EQ(entries[1]["file"], "B2.stl");
  EXPECT_EQ(entries[1]["status"], "done");
  EXPECT_EQ(entries[1]["verdict"]["reads"], "good");
  EXPECT_GT(entries[1]["depth"]["meanMm"].get<double>(), 0.1);
  EXPECT_EQ(entries[1]["sha256"]["output"].get<std::string>().size(), 64u);
  const Json report = Json::parse(contentOf(path("out/B2.stl.json")));
  EXPECT_EQ(report["verification"]["text"], "second; quoted");

  // `engrave` makes the same file from the same text.
  const Outcome alone = run({"engrave", model_, "--text", "second; quoted", "-o", path("alone.stl"), "--at", "0,0,5",
                             "--size", "21", "--process", "none", "--quiet"});
  ASSERT_EQ(alone.status, 0) << alone.err;
  EXPECT_EQ(contentOf(path("alone.stl")), contentOf(path("out/B2.stl")));
}

TEST_F(BatchCommandTest, LabelsEveryCodeFromATemplate) {
  const Outcome outcome = run(arguments({"--count", "2", "--text", "p/{n}", "--label", "No. {n:03}", "--reports"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json first = Json::parse(contentOf(path("out/1.stl.json"))),
             second = Json::parse(contentOf(path("out/2.stl.json")));
  EXPECT_EQ(first["label"]["text"], "No. 001");
  EXPECT_EQ(second["label"]["text"], "No. 002");
  EXPECT_EQ(first["label"]["capitalMm"], second["label"]["capitalMm"]);
}

TEST_F(BatchCommandTest, AnOpenMarkWritesTheFilesOfTheMarkThatItTook) {
  model_ = writeModel("thin.stl", shapes::plate({60, 60}, 1.05, 4, 4));
  const auto batch = [&] {
    return run({"batch", model_,   "-o",  path("out"),  "--at",     "0,0,1.05", "--up",
                "0,1,0", "--size", "25",  "--build-up", "code-up",  "--quiet",  "--count",
                "1",     "--text", "{n}", "--name",     "{id}.stl", "--mark",   "auto"});
  };
  ASSERT_EQ(batch().status, 0);
  ASSERT_EQ(manifest().size(), 1u);
  const Json row = manifest()[0];
  EXPECT_EQ(row["second"], "1-2.stl");
  EXPECT_EQ(row["sha256"]["second"].get<std::string>().size(), 64u);
  EXPECT_THAT(filesIn("out"), Contains("1-2.stl"));
  ASSERT_EQ(batch().status, 0);
  EXPECT_EQ(manifest().size(), 1u) << "the row is done";
}

TEST_F(BatchCommandTest, ARowThatDoesNotReadAsPrintedFailsAndIsRetried) {
  model_ = writeModel("tag.stl", shapes::box({12, 12, 3}));
  const auto batch = [&](const char* mayRetry) {
    return run({"batch", model_, "-o", path("out"), "--at", "0,0,1.5", "--size", "8", "--no-quiet-zone", "--quiet",
                "--count", "1", "--text", "https://example.com/{n}", mayRetry});
  };
  const Outcome first = batch("--reports");
  EXPECT_EQ(first.status, 1);
  EXPECT_THAT(first.out, HasSubstr("1 failed"));
  ASSERT_EQ(manifest().size(), 1u);
  EXPECT_EQ(manifest()[0]["status"], "failed");
  EXPECT_EQ(manifest()[0]["verdict"]["passed"], false);
  EXPECT_THAT(manifest()[0]["reason"].get<std::string>(), HasSubstr("does not read as printed"));
  const std::string lines = contentOf(path("out/manifest.jsonl"));
  writeText("out/manifest.jsonl", std::regex_replace(lines, std::regex("does not read as printed"), "is known"));
  EXPECT_EQ(batch("--reports").status, 1);
  EXPECT_THAT(manifest()[0]["reason"].get<std::string>(), HasSubstr("is known")) << "not tried again";
  EXPECT_EQ(batch("--retry-failed").status, 1);
  EXPECT_THAT(manifest()[0]["reason"].get<std::string>(), HasSubstr("does not read as printed"));
}

TEST_F(BatchCommandTest, ResumesAndRedoesChangedRows) {
  const std::string list = writeText("l.csv", "text\none\ntwo\nthree\n");
  ASSERT_EQ(run(arguments({"--list", list})).status, 0);
  const std::string first = contentOf(path("out/1.stl")), second = contentOf(path("out/2.stl"));
  const fs::file_time_type written = fs::last_write_time(path("out/1.stl"));

  fs::remove(path("out/3.stl"));
  writeText("out/2.stl", "changed");
  const Outcome again = run(arguments({"--list", list}));
  EXPECT_EQ(again.status, 1);
  EXPECT_THAT(again.err, HasSubstr("row 2 (2) failed: The file has changed since it was written"));
  EXPECT_EQ(contentOf(path("out/2.stl")), "changed");
  EXPECT_TRUE(fs::exists(path("out/3.stl")));
  EXPECT_EQ(fs::last_write_time(path("out/1.stl")), written);

  const Outcome retried = run(arguments({"--list", list, "--retry-failed"}));
  EXPECT_EQ(retried.status, 0) << retried.err;
  EXPECT_EQ(contentOf(path("out/2.stl")), second);
  EXPECT_EQ(contentOf(path("out/1.stl")), first);
}

TEST_F(BatchCommandTest, SharesMakeTheFilesOfASingleRun) {
  const std::vector<std::string> rows = {"--count", "3", "--text", "part {n:03}"};
  ASSERT_EQ(run(arguments(rows)).status, 0);
  for (const char* shard : {"0/2", "1/2"}) {
    std::vector<std::string> share = rows;
    share.insert(share.end(), {"--shard", shard});
    ASSERT_EQ(run(arguments(share, "shared")).status, 0);
    if (std::string(shard) == "0/2") {
      std::vector<std::string> merge = rows;
      merge.push_back("--merge");
      const Outcome early = run(arguments(merge, "shared"));
      EXPECT_EQ(early.status, 1);
      EXPECT_THAT(early.err, HasSubstr("row 2 (2) is missing"));
    }
  }
  std::vector<std::string> merge = rows;
  merge.push_back("--merge");
  const Outcome merged = run(arguments(merge, "shared"));
  EXPECT_EQ(merged.status, 0) << merged.err;
  for (const char* file : {"1.stl", "2.stl", "3.stl"})
    EXPECT_EQ(contentOf(path("out/" + std::string(file))), contentOf(path("shared/" + std::string(file))));
  EXPECT_EQ(manifest("shared").size(), 3u);
}

TEST_F(BatchCommandTest, ASeriesGoesOnAtItsFirstNumber) {
  const std::vector<std::string> rows = {"--count", "2", "--text", "part {n}"};
  ASSERT_EQ(run(arguments(rows)).status, 0);
  std::vector<std::string> later = rows;
  later.insert(later.end(), {"--first", "1001"});
  const Outcome outcome = run(arguments(later));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("2 rows: 2 done, 0 failed, 0 missing"));
  EXPECT_EQ(filesIn("out"),
            (std::vector<std::string>{"1.stl", "1001.stl", "1002.stl", "2.stl", "manifest.csv", "manifest.jsonl"}));
  const std::vector<Json> entries = manifest();
  ASSERT_EQ(entries.size(), 4u);
  EXPECT_EQ(entries[2]["number"], 1001);
  EXPECT_EQ(entries[2]["text"], "part 1001");
  const std::string before = contentOf(path("out/1001.stl"));
  EXPECT_EQ(run(arguments(later)).status, 0) << "done before";
  EXPECT_EQ(contentOf(path("out/1001.stl")), before);
}

TEST_F(BatchCommandTest, ARowMayHaveItsOwnModel) {
  writeModel("thick.stl", shapes::plate({40, 40}, 9, 4, 4));
  const std::string list = writeText("l.csv", "id,Model,text\n1,thick.stl,a\n2,,b\n3,thick.stl,c\n");
  std::vector<std::string> all = {"batch",  model_, "-o",        path("out"), "--list", list,
                                  "--size", "21",   "--process", "none",      "--quiet"};
  const Outcome outcome = run(all);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto thickness = [&](const std::string& name) {
    const auto soup = readBack(name);
    EXPECT_TRUE(soup.has_value());
    const auto [low, high] = std::minmax_element(soup->positions.begin(), soup->positions.end(),
                                                 [](const Vec3& a, const Vec3& b) { return a.z < b.z; });
    return high->z - low->z;
  };
  EXPECT_NEAR(thickness("out/1.stl"), 9, 1e-3);
  EXPECT_NEAR(thickness("out/2.stl"), 5, 1e-3);
  EXPECT_NEAR(thickness("out/3.stl"), 9, 1e-3);

  const std::string wrong = writeText("w.csv", "id,model,text\n1,thick.stl,a\n2,absent.stl,b\n");
  const Outcome absent = run(arguments({"--list", wrong}, "none"));
  EXPECT_EQ(absent.status, 3);
  EXPECT_THAT(absent.err, HasSubstr("Line 3: The model \"absent.stl\""));
  EXPECT_THAT(filesIn("none"), IsEmpty());
  EXPECT_EQ(run(arguments({"--list", list, "--per-plate", "2"}, "none")).status, 2);
  const Outcome without = run({"batch", "--list", list, "-o", path("none")});
  EXPECT_EQ(without.status, 2);
  EXPECT_THAT(without.err, HasSubstr("Line 3: The row names no model"));
  EXPECT_THAT(without.err, HasSubstr("hint: Fill in its column"));
}

TEST_F(BatchCommandTest, AModelThatCannotBeReadAgainIsRefusedBeforeAnythingIsWritten) {
  ASSERT_EQ(mkfifo(path("pipe.stl").c_str(), 0600), 0);
  for (const auto& [model, reason] :
       {std::pair("pipe.stl", "It is a pipe"), std::pair("none.stl", "cannot be opened")}) {
    model_ = path(model);
    const Outcome outcome = run(arguments({"--count", "1", "--text", "a"}));
    EXPECT_EQ(outcome.status, 3);
    EXPECT_THAT(outcome.err, HasSubstr(reason));
    EXPECT_THAT(filesIn("out"), IsEmpty());
  }
}

TEST_F(BatchCommandTest, TheModelAndTheListAreNotOverwritten) {
  ASSERT_TRUE(fs::create_directory(path("out")));
  const std::string inside = writeModel("out/1.stl", shapes::plate({40, 40}, 5, 4, 4));
  const std::string before = contentOf(inside);
  const Outcome outcome = run({"batch", inside, "--count", "2", "--text", "{n}", "-o", path("out")});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("would overwrite"));
  EXPECT_EQ(contentOf(inside), before);
  const std::string list = writeText("out/manifest.csv", "id,text\n7,a\n");
  EXPECT_EQ(run(arguments({"--list", list})).status, 2);
}

TEST_F(BatchCommandTest, RefusesOptionsWithoutEffect) {
  EXPECT_EQ(run(arguments({"--stream", "--count", "2"})).status, 2);
  EXPECT_EQ(run(arguments({"--count", "2", "--text", "{n}", "--merge", "--shard", "0/2"})).status, 2);
  const Outcome slicer = run(arguments({"--count", "2", "--text", "{n}", "--for", "bambu"}));
  EXPECT_EQ(slicer.status, 2);
  EXPECT_THAT(slicer.err, HasSubstr("--for is only for 3MF"));
}

TEST_F(BatchCommandTest, NumbersOfAListKeepTheirCharacters) {
  const std::string list = writeText("l.jsonl", R"({"id": "a", "iccid": 89490200001234567890})");
  const Outcome outcome = run(arguments({"--list", list, "--text", "ICCID:{iccid}"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(manifest()[0]["text"], "ICCID:89490200001234567890");
}

TEST_F(BatchCommandTest, PlacesNamedPartsSideBySideOnPlates) {
  const std::string list = writeText("l.csv", "id,text\nA,one & only\nB,two\nC,three\n");
  const Outcome outcome = run(arguments({"--list", list, "--per-plate", "2"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(filesIn("out"),
            (std::vector<std::string>{"manifest.csv", "manifest.jsonl", "plate-001.3mf", "plate-002.3mf"}));
  EXPECT_EQ(manifest()[1]["file"], "plate-001.3mf");
  EXPECT_EQ(manifest()[2]["file"], "plate-002.3mf");
  const auto plate = readBack("out/plate-001.3mf");
  ASSERT_TRUE(plate);
  ASSERT_EQ(plate->parts.size(), 2u);
  EXPECT_EQ(plate->parts[0].name, "A");
  EXPECT_EQ(plate->parts[1].name, "B");
  Box3 box;
  for (const Vec3 p : plate->positions) box.add(p);
  EXPECT_LT(glm::length(box.min), 1e-6);
  EXPECT_LT(glm::length(box.max - Vec3(85, 40, 5)), 1e-6);  // two plates of 40 mm, 5 mm apart

  // A failed row leaves the others on their plate. A plate is always made again as a whole.
  const std::string failing = writeText("l.csv", "id,text,size\nA,one & only,\nB,two,39\nC,three,\n");
  const Outcome partly = run(arguments({"--list", failing, "--per-plate", "2", "--name", "{id}.stl"}, "partly"));
  EXPECT_EQ(partly.status, 1);
  EXPECT_EQ(filesIn("partly"), (std::vector<std::string>{"A.stl", "C.stl", "manifest.csv", "manifest.jsonl",
                                                         "plate-001.3mf", "plate-002.3mf"}));
  EXPECT_EQ(manifest("partly")[0]["plate"], "plate-001.3mf");
  EXPECT_EQ(readBack("partly/plate-001.3mf")->parts.size(), 1u);
  const std::string before = contentOf(path("partly/plate-001.3mf"));
  writeText("partly/A.stl", "changed");
  EXPECT_EQ(
      run(arguments({"--list", failing, "--per-plate", "2", "--name", "{id}.stl", "--retry-failed"}, "partly")).status,
      1);
  EXPECT_NE(contentOf(path("partly/A.stl")), "changed");
  EXPECT_EQ(contentOf(path("partly/plate-001.3mf")), before);
}

TEST_F(BatchCommandTest, SimulatesThePrintOfEveryNthRow) {
  std::vector<std::string> rows = arguments({"--count", "3", "--text", "part {n}", "--print-every", "2"});
  rows.erase(std::find(rows.begin(), rows.end(), "--process"));
  rows.erase(std::find(rows.begin(), rows.end(), "none"));
  ASSERT_EQ(run(rows).status, 0);
  const std::vector<Json> entries = manifest();
  EXPECT_TRUE(entries[0].contains("printed"));
  EXPECT_FALSE(entries[1].contains("printed"));
  EXPECT_EQ(entries[2]["printed"]["tries"], frontalTries());
  EXPECT_EQ(entries[1]["reading"]["tries"], frontalTries());
}

TEST_F(BatchCommandTest, AFailedRowDoesNotStopTheRest) {
  const std::string list = writeText("l.csv", "text,size\na,\nb,39\nc,\n");
  const Outcome outcome = run(arguments({"--list", list}));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("3 rows: 2 done, 1 failed"));
  EXPECT_THAT(outcome.err, HasSubstr("row 2 (2) failed: "));
  EXPECT_FALSE(fs::exists(path("out/2.stl")));
  EXPECT_TRUE(fs::exists(path("out/3.stl")));
  EXPECT_THAT(manifest()[1]["reason"].get<std::string>(), HasSubstr("mm"));

  // A failed row also removes its file made with other settings, but keeps a file that somebody changed.
  writeText("out/3.stl", "changed");
  EXPECT_EQ(run(arguments({"--list", writeText("l.csv", "text,size\na,39\nb,39\nc,39\n")})).status, 1);
  EXPECT_EQ(filesIn("out"), (std::vector<std::string>{"3.stl", "manifest.csv", "manifest.jsonl"}));
}

TEST_F(BatchCommandTest, RefusesNumbersOfRowsThatNoBatchCanHave) {
  for (const char* option : {"--count", "--per-plate", "--print-every"})
    for (const char* number : {"0", "-3", "99999999999999", "1e3"}) {
      const Outcome outcome = run(arguments({"--text", "{n}", option, number}));
      EXPECT_EQ(outcome.status, 2) << option << ' ' << number;
      EXPECT_THAT(outcome.err, HasSubstr(option)) << number;
    }
}

TEST_F(BatchCommandTest, RefusesAListBeforeAnythingIsWritten) {
  for (const auto& [text, says] : std::vector<std::pair<std::string, std::string>>{
           {"text\na\na\n", "Line 3: The text \"a\" is also in line 2"},
           {"text,file\na,../x.stl\n", "Line 2: \"../x.stl\" is not a plain file name"},
           {"id,words\n1,a\n", "The list has no column “text”"},
           {"text\n\"a\n", "A quotation mark in line 2"}}) {
    const Outcome refused = run(arguments({"--list", writeText("l.csv", text)}));
    EXPECT_EQ(refused.status, 3) << text;
    EXPECT_THAT(refused.err, HasSubstr(says));
    EXPECT_THAT(filesIn("out"), IsEmpty());
  }
  EXPECT_EQ(run(arguments({"--count", "2"})).status, 3);
  EXPECT_EQ(run(arguments({"--text", "x"})).status, 2);
  EXPECT_EQ(run(arguments({"--count", "2", "--text", "{n}", "--shard", "2/2"})).status, 2);
  EXPECT_EQ(run(arguments({"--count", "2", "--text", "{n}", "--shards", "2"})).status, 2);
  EXPECT_THAT(filesIn("out"), IsEmpty());
}

TEST_F(BatchCommandTest, TakesItsShareFromTheSchedulersEnvironment) {
  const std::vector<std::pair<std::vector<const char*>, std::string>> engines = {
      {{"SLURM_ARRAY_TASK_ID=12", "SLURM_ARRAY_TASK_MIN=10", "SLURM_ARRAY_TASK_COUNT=3"}, "share 2 of 3"},
      {{"SLURM_ARRAY_TASK_ID=2", "SLURM_ARRAY_TASK_MIN=2", "SLURM_ARRAY_TASK_COUNT=1", "--shards"}, "share 2 of 3"},
      {{"AWS_BATCH_JOB_ARRAY_INDEX=2", "AWS_BATCH_JOB_ARRAY_SIZE=3"}, "share 2 of 3"},
      {{"JOB_COMPLETION_INDEX=2", "--shards"}, "share 2 of 3"}};
  for (const auto& [variables, says] : engines) {
    std::vector<std::string> names;
    std::vector<std::string> rows = {"--count", "2", "--text", "{n}"};  // no rows are left for the third share
    for (const std::string variable : variables) {
      const std::size_t equals = variable.find('=');
      if (equals == variable.npos) {
        rows.insert(rows.end(), {variable, "3"});
        continue;
      }
      names.push_back(variable.substr(0, equals));
      ::setenv(names.back().c_str(), variable.substr(equals + 1).c_str(), 1);
    }
    const Outcome outcome = run(arguments(rows));
    for (const std::string& name : names) ::unsetenv(name.c_str());
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(says));
    EXPECT_THAT(filesIn("out"), Contains("manifest.2-of-3.jsonl"));
  }
}

TEST_F(BatchCommandTest, AnswersEveryRequestOfAStream) {
  const std::string nested(100'000, '['), endless(3 << 20, 'x');
  writeText("requests", nested + "\n" + endless + "\n" + R"({"id": "a", "text": "first"}
nonsense
{"id": "b", "text": "second", "minWallMm": -3}
{"id": "a", "text": "first"}
{"id": "a", "text": "another"}
)");
  std::vector<std::string> stream = arguments({"--stream"});
  const auto at = std::find(stream.begin(), stream.end(), "--at");
  stream.erase(at, at + 2);  // when the command finds a spot by itself, stdout still has only the answers
  stream.back() += "' <'" + path("requests");  // the fixture puts quotes around it
  const Outcome outcome = run(stream);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  std::vector<Json> answers = linesOf(outcome.out);
  ASSERT_EQ(answers.size(), 7u);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(answers[i]["status"], "refused");
  EXPECT_THAT(answers[1]["reason"].get<std::string>(), HasSubstr("more than"));
  answers.erase(answers.begin(), answers.begin() + 2);
  EXPECT_EQ(answers[0]["status"], "done");
  EXPECT_EQ(answers[1]["status"], "refused");
  EXPECT_EQ(answers[2]["status"], "refused");
  EXPECT_EQ(answers[3], answers[0]);
  EXPECT_EQ(answers[4]["status"], "refused");
  EXPECT_THAT(answers[4]["reason"].get<std::string>(), HasSubstr("already exists"));
  EXPECT_EQ(filesIn("out"), (std::vector<std::string>{"a.stl", "manifest.jsonl"}));
}

TEST_F(BatchCommandTest, AStreamOverwritesNeitherAModelNorAFileWhoseNameDiffersInCapitals) {
  fs::create_directory(path("out"));
  for (const char* name : {"plate.stl", "other.stl"}) fs::copy_file(model_, path("out/") + name);
  model_ = path("out/plate.stl");
  const std::string other = path("out/other.stl");
  writeText("requests", R"({"text": "a", "file": "Plate.stl"})"
                        "\n{\"text\": \"b\", \"file\": \"K.stl\", \"model\": \"" +
                            other + "\"}\n" +
                            R"({"text": "c", "file": "other.stl"}
{"text": "d", "file": "k.stl"}
{"text": "b", "file": "k.stl"}
)");
  std::vector<std::string> stream = arguments({"--stream"});
  stream.back() += "' <'" + path("requests");  // the fixture puts quotes around it
  const std::vector<Json> answers = linesOf(run(stream).out);
  ASSERT_EQ(answers.size(), 5u);
  EXPECT_THAT(answers[0]["reason"].get<std::string>(), HasSubstr("would overwrite " + model_));
  EXPECT_EQ(answers[1]["status"], "done");
  EXPECT_THAT(answers[2]["reason"].get<std::string>(), HasSubstr("would overwrite " + other));
  for (const std::size_t i : {3u, 4u})
    EXPECT_THAT(answers[i]["reason"].get<std::string>(), HasSubstr("The file \"K.stl\" already exists")) << i;
  EXPECT_EQ(filesIn("out"), (std::vector<std::string>{"K.stl", "manifest.jsonl", "other.stl", "plate.stl"}));
  EXPECT_EQ(contentOf(model_), contentOf(other));
}

TEST_F(BatchCommandTest, AColumnNamedLikeAFlagGetsAHint) {
  const std::string list = writeText("l.csv", "text,Min-Wall,--size,note\na,2,10,x\n");
  const Outcome outcome = run(arguments({"--list", list}));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("unused columns: Min-Wall (the setting is called minWallMm), --size (the setting "
                                     "is called size), note\n"));
}

TEST_F(BatchCommandTest, AStreamAnswersRequestsWithoutAModelAndSeveralInOneLine) {
  writeText("requests", R"({"text": "a"}
[{"text": "b", "model": "plate.stl"}, {"text": "c", "model": "plate.stl"}]
{"text": "d", "model": "absent.stl"}
)");
  const Outcome outcome = run({"batch", "--stream", "--quiet", "-o", path("out"), "--size",
                               "21' <'" + path("requests")});  // the fixture puts quotes around it
  EXPECT_EQ(outcome.status, 1) << "the last one failed: " << outcome.err;
  const std::vector<Json> answers = linesOf(outcome.out);
  ASSERT_EQ(answers.size(), 3u);
  EXPECT_EQ(answers[0]["status"], "refused");
  EXPECT_THAT(answers[0]["reason"].get<std::string>(), HasSubstr("names no model"));
  EXPECT_EQ(answers[1]["status"], "refused");
  EXPECT_THAT(answers[1]["reason"].get<std::string>(), HasSubstr("not a JSON object"));
  EXPECT_EQ(answers[2]["status"], "failed");
}

}  // namespace
}  // namespace qrelief
