// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_unit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace qrelief {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using State = EarlierRow::State;

BatchUnit unitOf(std::size_t rows, const std::string& plate = {}, bool hasOwnFiles = true) {
  BatchUnit unit = {{}, plate, hasOwnFiles, "model", "scale 2"};
  for (std::size_t i = 0; i < rows; ++i) {
    BatchRow row;
    row.number = i + 1;
    row.id = std::string(1, static_cast<char>('a' + i));
    row.file = row.id + ".stl";
    row.request.code.text = "text " + row.id;
    unit.rows.push_back(std::move(row));
  }
  return unit;
}

TEST(BatchUnit, ARowsHashDependsOnItsSettingsAndTheModel) {
  const BatchUnit unit = unitOf(1);
  EXPECT_THAT(matesToHash(unit), IsEmpty());
  EXPECT_THAT(rowsToHash(unit, {}), ElementsAre(settingsToHash(unit.rows[0], "scale 2")));
}

TEST(BatchUnit, OnAPlateItDependsOnAllRows) {
  const BatchUnit unit = unitOf(2, "plate-001.3mf");
  EXPECT_THAT(matesToHash(unit), ElementsAre(settingsToHash(unit.rows[0], {}), settingsToHash(unit.rows[1], {})));
  const std::vector<std::string> mates = {"11", "22"};
  EXPECT_THAT(rowsToHash(unit, mates),
              ElementsAre(settingsToHash(unit.rows[0], "scale 21122"), settingsToHash(unit.rows[1], "scale 21122")));
}

TEST(BatchUnit, APendingEntryNamesTheFileAndThePlate) {
  const std::vector<std::string> hashes = {"h1", "h2"};
  const auto both = pendingEntries(unitOf(2, "plate-001.3mf"), hashes);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[1].number, 2u);
  EXPECT_EQ(both[1].id, "b");
  EXPECT_EQ(both[1].text, "text b");
  EXPECT_EQ(both[1].file, "b.stl");
  EXPECT_EQ(both[1].plate, "plate-001.3mf");
  EXPECT_EQ(both[1].status, RowStatus::Failed);
  EXPECT_EQ(both[1].sha256, (RowHashes{"model", "h2", "", ""}));
  const auto shared = pendingEntries(unitOf(1, "plate-001.3mf", false), {});
  EXPECT_EQ(shared[0].file, "plate-001.3mf");
  EXPECT_EQ(shared[0].plate, "");
  EXPECT_EQ(shared[0].sha256.settings, "");
}

struct EarlierRowTest : testing::Test {
  ManifestEntry listed(RowStatus status, const std::string& output = "out") const {
    ManifestEntry entry = pending;
    entry.status = status;
    entry.sha256.output = output;
    return entry;
  }
  void add(const ManifestEntry& entry) {
    row.add(entry, pending, [&](const std::string& file) { return file.empty() ? "" : onDisk; });
  }

  const ManifestEntry pending = pendingEntries(unitOf(1), std::vector<std::string>{"h"})[0];
  std::optional<std::string> onDisk = "out";
  EarlierRow row;
};

TEST_F(EarlierRowTest, IsDoneIfItsFileHasTheListedHash) {
  EXPECT_TRUE(row.isOpen(false));
  add(listed(RowStatus::Done));
  EXPECT_EQ(row.state, State::Done);
  EXPECT_FALSE(row.isOpen(true));
  add(listed(RowStatus::Failed));
  EXPECT_EQ(row.state, State::Done);
}

TEST_F(EarlierRowTest, IsNewIfItsFileIsGoneOrItsInputsDiffer) {
  onDisk.reset();
  add(listed(RowStatus::Done));
  onDisk = "out";
  for (std::string RowHashes::*hash : {&RowHashes::input, &RowHashes::settings}) {
    ManifestEntry other = listed(RowStatus::Done);
    other.sha256.*hash = "other";
    add(other);
  }
  for (std::string ManifestEntry::*name : {&ManifestEntry::file, &ManifestEntry::plate}) {
    ManifestEntry other = listed(RowStatus::Done);
    other.*name = "other.stl";
    add(other);
  }
  EXPECT_EQ(row.state, State::New);
  EXPECT_TRUE(row.isOpen(false));
}

TEST_F(EarlierRowTest, OfAnOpenMarkMayHaveASecondFileOrNot) {
  BatchUnit unit = unitOf(1);
  unit.rows[0].request.marking.isOpen = true;
  const ManifestEntry open = pendingEntries(unit, std::vector<std::string>{"h"})[0];
  EXPECT_EQ(open.second, "");
  for (const auto& [second, state] :
       {std::pair("", State::Done), std::pair("a-2.stl", State::Done), std::pair("b-2.stl", State::New)}) {
    ManifestEntry before = open;
    before.status = RowStatus::Done;
    before.sha256.output = "out";
    before.second = second;
    before.sha256.second = *second ? "out" : "";
    EarlierRow earlier;
    earlier.add(before, open, [](const std::string& file) { return file.empty() ? "" : "out"; });
    EXPECT_EQ(earlier.state, state) << second;
  }
}

TEST_F(EarlierRowTest, IsOpenAfterAFailureOrAChangeOnlyIfRetried) {
  add(listed(RowStatus::Failed));
  EXPECT_EQ(row.state, State::Failed);
  EXPECT_FALSE(row.isOpen(false));
  EXPECT_TRUE(row.isOpen(true));
  add(listed(RowStatus::Done, "before the change"));
  EXPECT_EQ(row.state, State::Changed);
  EXPECT_FALSE(row.isOpen(false));
  EXPECT_TRUE(row.isOpen(true));
  add(listed(RowStatus::Done));
  EXPECT_EQ(row.state, State::Done);
}

}  // namespace
}  // namespace qrelief
