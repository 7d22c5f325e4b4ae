// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/batch_folder.h"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <iterator>
#include <sys/stat.h>
#include <unistd.h>

#include "native/files.h"
#include "native/sha256.h"

namespace qrelief {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;
using State = EarlierRow::State;

class BatchFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    path_ = fs::temp_directory_path() / (std::string("qrelief_") + test.name() + std::to_string(::getpid()));
    fs::create_directory(path_);
  }
  void TearDown() override { fs::remove_all(path_); }

  BatchFolder folder(const Shard& shard = {}) const {
    auto opened = BatchFolder::open(path_, shard);
    EXPECT_TRUE(opened);
    return std::move(*opened);
  }

  /// Returns a manifest entry for a row whose file contains its id.
  ManifestEntry entry(std::size_t number, RowStatus status = RowStatus::Done, const std::string& id = "id") const {
    ManifestEntry row;
    row.number = number;
    row.id = id;
    row.file = std::to_string(number) + ".stl";
    row.sha256 = {"in", "settings", sha256(id), {}};
    row.status = status;
    return row;
  }
  void writeOutput(const ManifestEntry& entry) const { ASSERT_TRUE(writeFileAtomically(path_ / entry.file, entry.id)); }
  static std::vector<std::string> rowsOf(const BatchFolder& folder) {
    std::vector<std::string> rows;
    EXPECT_TRUE(folder.forEach([&](const ManifestEntry& entry) -> Status {
      rows.push_back(std::to_string(entry.number) + entry.id);
      return {};
    }));
    return rows;
  }
  std::string contentOf(const std::string& name) const {
    std::ifstream stream(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  fs::path path_;
};

TEST_F(BatchFolderTest, VisitsTheLastStateOfAllRowsInOrder) {
  for (const std::size_t share : {1u, 0u}) {
    BatchFolder own = folder({share, 2});
    for (const std::size_t number : {share + 3, share + 1}) {
      ASSERT_TRUE(own.append(entry(number, RowStatus::Failed, "tried")));
      ASSERT_TRUE(own.append(entry(number, RowStatus::Done, "done")));
    }
  }
  EXPECT_THAT(rowsOf(folder()), ElementsAre("1done", "2done", "3done", "4done"));
}

TEST_F(BatchFolderTest, PrefersADoneRowToAnUnfinishedOne) {
  ASSERT_TRUE(folder({0, 2}).append(entry(1, RowStatus::Done, "done")));
  ASSERT_TRUE(folder({0, 3}).append(entry(1, RowStatus::Failed, "failed")));
  EXPECT_THAT(rowsOf(folder()), ElementsAre("1done"));
  EXPECT_THAT(folder().doubles(), IsEmpty());
  ASSERT_TRUE(folder({0, 4}).append(entry(1, RowStatus::Done, "again")));
  EXPECT_THAT(folder().doubles(), ElementsAre(1u));
}

TEST_F(BatchFolderTest, RecognisesADoneRowByItsHashesAndFile) {
  BatchFolder own = folder();
  const ManifestEntry done = entry(1);
  EXPECT_EQ(own.known(done).state, State::New);
  ASSERT_TRUE(own.append(done));
  EXPECT_EQ(own.known(done).state, State::New) << "its file is not there";
  writeOutput(done);
  EXPECT_EQ(own.known(done).state, State::Done);
  ManifestEntry other = done;
  other.sha256.settings = "others";
  EXPECT_EQ(own.known(other).state, State::New);
  ASSERT_TRUE(writeFileAtomically(path_ / done.file, "changed"));
  EXPECT_EQ(own.known(done).state, State::Changed);
  ASSERT_TRUE(own.append(entry(2, RowStatus::Failed)));
  EXPECT_EQ(own.known(entry(2)).state, State::Failed);
}

TEST_F(BatchFolderTest, ComparesAndRemovesTheSecondFile) {
  ManifestEntry done = entry(1);
  done.second = "second.stl";
  done.sha256.second = sha256("two");
  writeOutput(done);
  BatchFolder own = folder();
  ASSERT_TRUE(own.append(done));
  EXPECT_EQ(own.known(done).state, State::New) << "the second file is missing";
  ASSERT_TRUE(writeFileAtomically(path_ / done.second, std::string("one")));
  EXPECT_EQ(own.known(done).state, State::Changed);
  ASSERT_TRUE(writeFileAtomically(path_ / done.second, std::string("two")));
  EXPECT_EQ(own.known(done).state, State::Done);
  own.removeOutdated(done);
  EXPECT_FALSE(fs::exists(path_ / done.second));
  EXPECT_FALSE(fs::exists(path_ / done.file));
}

TEST_F(BatchFolderTest, RecognisesRowsDoneWithAnotherNumberOfShares) {
  const ManifestEntry done = entry(1);
  writeOutput(done);
  ASSERT_TRUE(folder({0, 2}).append(done));
  EXPECT_EQ(folder({0, 3}).known(done).state, State::Done);
  EXPECT_EQ(folder({0, 2}).known(done).state, State::Done);
  EXPECT_EQ(folder({1, 2}).known(done).state, State::New) << "is none of its rows";
}

TEST_F(BatchFolderTest, DropsATruncatedLastLine) {
  ASSERT_TRUE(folder().append(entry(1)));
  const std::string whole = contentOf("manifest.jsonl"), next = manifestLine(entry(2));
  for (std::size_t i = 0; i <= next.size(); ++i) {
    std::ofstream(path_ / "manifest.jsonl", std::ios::binary) << whole << next.substr(0, i);
    BatchFolder own = folder();
    EXPECT_THAT(rowsOf(own), ElementsAre("1id")) << i;
    ASSERT_TRUE(own.append(entry(3)));
    EXPECT_THAT(rowsOf(own), ElementsAre("1id", "3id")) << i;
  }
  std::ofstream(path_ / "manifest.jsonl", std::ios::binary) << std::string(200000, ' ');
  EXPECT_THAT(rowsOf(folder()), IsEmpty());
  EXPECT_EQ(fs::file_size(path_ / "manifest.jsonl"), 0u);
}

TEST_F(BatchFolderTest, NamesALineThatIsNotOfAManifest) {
  ASSERT_TRUE(folder().append(entry(1)));
  std::ofstream(path_ / "manifest.jsonl", std::ios::app) << "{}\n";
  const auto opened = BatchFolder::open(path_, {});
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().message.code, "manifest-not-read");
}

TEST_F(BatchFolderTest, WritesTheManifestOfAllShares) {
  const std::string second = manifestLine(entry(2)), first = manifestLine(entry(1));
  ASSERT_TRUE(folder({1, 2}).append(entry(2)));
  ASSERT_TRUE(folder({0, 2}).append(entry(1)));
  ASSERT_TRUE(folder({0, 2}).append(entry(3)));
  ASSERT_TRUE(folder().writeManifest(2));
  EXPECT_EQ(contentOf("manifest.jsonl"), first + "\n" + second + "\n");
  EXPECT_EQ(contentOf("manifest.csv"), manifestCsvHeader() + manifestCsvLine(entry(1)) + manifestCsvLine(entry(2)));
}

TEST_F(BatchFolderTest, AllowsOneProcessPerShare) {
  const BatchFolder own = folder({0, 2});
  const auto second = BatchFolder::open(path_, {0, 2});
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().message.code, "batch-folder-in-use");
  EXPECT_TRUE(BatchFolder::open(path_, {1, 2}));
}

TEST_F(BatchFolderTest, DoesNotWaitForPipes) {
  {
    BatchFolder first = folder();
    ASSERT_TRUE(first.append(entry(1)));
  }
  ASSERT_EQ(::mkfifo((path_ / "1.stl").c_str(), 0600), 0);
  ASSERT_EQ(::mkfifo((path_ / "manifest.0-of-2.jsonl").c_str(), 0600), 0);
  EXPECT_EQ(folder().known(entry(1)).state, State::Changed);
}

}  // namespace
}  // namespace qrelief
