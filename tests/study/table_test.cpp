// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/table.h"

#include <filesystem>
#include <fmt/ranges.h>
#include <fstream>
#include <gmock/gmock.h>
#include <iterator>
#include <set>
#include <unistd.h>

#include "support/paths.h"

namespace qrelief::study {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsNull;
using testing::Pointee;

/// Fixture with an experiment of two models by two levels, and a folder that is deleted when the test ends.
class StudyTable : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  static Experiment experiment() {
    return {"squares", {"model", "level"},         {"depth_mm"}, {{"b", "1"}, {"b", "2"}, {"a", "1"}, {"a", "2"}},
            {},        dependingOn({{"light", 1}})};
  }
  Table opened(const std::string& name = "t.csv") const {
    auto table = Table::open(experiment(), path(name));
    EXPECT_TRUE(table.has_value());
    return std::move(*table);
  }
  std::string path(const std::string& name = "t.csv") const { return (folder_ / name).string(); }
  std::string contents() const {
    std::ifstream stream(path());
    return {std::istreambuf_iterator<char>(stream), {}};
  }

 private:
  fs::path folder_ = fs::temp_directory_path() / ("qrelief-table-" + std::to_string(::getpid()));
};

TEST_F(StudyTable, KeepsMeasurementsForTheNextRun) {
  Table first = opened();
  EXPECT_THAT(first.find({"a", "1"}), IsNull());
  ASSERT_TRUE(first.add({"a", "1"}, {"0.5", ""}).has_value());
  EXPECT_THAT(opened().find({"a", "1"}), Pointee(ElementsAre("0.5", "", "light 1")));
}

TEST_F(StudyTable, IsWrittenInCaseOrder) {
  Table table = opened();
  for (const Row& key : {Row{"a", "1"}, Row{"b", "2"}, Row{"b", "1"}, Row{"x", "9"}})
    ASSERT_TRUE(table.add(key, {"1", ""}).has_value());
  ASSERT_TRUE(table.write(experiment()).has_value());
  EXPECT_EQ(contents(), "model,level,depth_mm,failed,version\nb,1,1,,light 1\nb,2,1,,light 1\na,1,1,,light 1\n");
}

TEST_F(StudyTable, DropsATruncatedLine) {
  std::ofstream(path()) << "model,level,depth_mm,failed,version\na,1,0.5,,light 1\na,2,0.";
  EXPECT_THAT(opened().find({"a", "1"}), Pointee(ElementsAre("0.5", "", "light 1")));
  EXPECT_THAT(opened().find({"a", "2"}), IsNull());
}

TEST_F(StudyTable, IgnoresARowOfAnotherVersion) {
  std::ofstream(path()) << "model,level,depth_mm,failed,version\na,1,0.5,,light 0\n";
  EXPECT_THAT(opened().find({"a", "1"}), IsNull());
}

TEST_F(StudyTable, RefusesOtherColumns) {
  std::ofstream(path()) << "model,depth_mm,failed,version\na,0.5,,light 1\n";
  const auto table = Table::open(experiment(), path());
  ASSERT_FALSE(table.has_value());
  EXPECT_EQ(table.error().message.code, "study-other-columns");
}

TEST_F(StudyTable, KeepsTheRowsOfOtherProcesses) {
  Table part = opened("t.csv.1-of-2");
  ASSERT_TRUE(part.add({"a", "2"}, {"2", ""}).has_value());
  Table whole = opened();
  whole.take(part);
  EXPECT_THAT(whole.find({"a", "2"}), Pointee(ElementsAre("2", "", "light 1")));
}

TEST(Study, CaseNamesAreUniqueAndHaveAllKeys) {
  for (const Experiment& experiment : allExperiments()) {
    EXPECT_EQ(std::set<Row>(experiment.cases.begin(), experiment.cases.end()).size(), experiment.cases.size())
        << experiment.name;
    for (const Row& key : experiment.cases) EXPECT_EQ(key.size(), experiment.keys.size()) << experiment.name;
  }
}

/// Checks that committed tables match the current experiments: their columns, and no cases but theirs.
TEST(Study, CommittedTablesHaveAllCasesOfThisVersion) {
  const fs::path results = sourceFolder() / "study" / "results";
  int matches = 0;
  for (const Experiment& experiment : allExperiments()) {
    const fs::path path = results / (experiment.name + ".csv");
    if (!fs::exists(path)) continue;
    ++matches;
    const auto table = Table::open(experiment, path.string());
    ASSERT_TRUE(table.has_value()) << experiment.name;
    for (const Row& key : experiment.cases)
      EXPECT_TRUE(table->find(key)) << fmt::format("{}: measure {} anew", experiment.name, fmt::join(key, ","));
    std::ifstream stream(path);
    const auto lines = std::count(std::istreambuf_iterator<char>(stream), {}, '\n');
    EXPECT_EQ(lines - 1, std::ssize(experiment.cases)) << experiment.name;
  }
  EXPECT_GT(matches, 0);
}

}  // namespace
}  // namespace qrelief::study
