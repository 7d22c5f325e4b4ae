// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace qrelief {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Loss = BatchProgress::Loss;
constexpr auto kDone = RowStatus::Done, kFailed = RowStatus::Failed;

ManifestEntry entry(std::size_t row, RowStatus status, const std::string& reason = {}) {
  ManifestEntry entry;
  entry.number = row + 1;
  entry.status = status;
  entry.reason = reason;
  return entry;
}

void settle(BatchProgress& progress, std::size_t unit, RowStatus status = kDone) {
  std::vector<ManifestEntry> entries;
  for (std::size_t row = progress.layout().begin(unit); row < progress.layout().end(unit); ++row)
    entries.push_back(entry(row, status));
  progress.settle(entries);
}

/// Returns the first letter of each row's state.
std::string statesOf(const BatchProgress& progress) {
  std::string letters;
  for (std::size_t row = 0; row < progress.layout().rows; ++row) letters += rowStateName(progress.state(row))[0];
  return letters;
}

TEST(BatchProgress, NamesEachState) {
  for (const RowState state : {RowState::Waiting, RowState::Running, RowState::Done, RowState::Failed})
    EXPECT_EQ(readRowState(rowStateName(state)), state);
  EXPECT_EQ(readRowState("all"), std::nullopt);
}

TEST(BatchProgress, GivesEachWaitingRowOnce) {
  BatchProgress progress({.rows = 3});
  progress.note(entry(1, kDone));
  EXPECT_EQ(progress.take(), 0u);
  EXPECT_EQ(progress.take(), 2u);
  EXPECT_EQ(progress.take(), std::nullopt);
  EXPECT_EQ(statesOf(progress), "rdr");
  settle(progress, 0);
  settle(progress, 2, kFailed);
  EXPECT_EQ(statesOf(progress), "ddf");
  EXPECT_EQ(progress.counts().finished(), 3u);
}

TEST(BatchProgress, TheLastLineAboutARowCounts) {
  BatchProgress progress({.rows = 2});
  progress.note(entry(0, kFailed, "no depth"));
  EXPECT_EQ(progress.reason(0), "no depth");
  progress.note(entry(0, kDone));
  EXPECT_EQ(progress.reason(0), "");
  progress.note(entry(1, kDone));
  progress.note(entry(1, kFailed, "changed"));
  EXPECT_EQ(statesOf(progress), "df");
}

TEST(BatchProgress, IgnoresLinesAboutRowsThatItDoesNotHave) {
  BatchProgress progress({.rows = 2});
  progress.note(entry(2, kDone));
  progress.note(entry(static_cast<std::size_t>(-1), kDone));  // number 0
  EXPECT_EQ(progress.counts().waiting, 2u);
}

TEST(BatchProgress, CarvesAPlateAsAWholeIfOneOfItsRowsWaits) {
  BatchProgress progress({.rows = 8, .perPlate = 3});
  for (const std::size_t row : {0, 1, 2, 4}) progress.note(entry(row, kDone));
  EXPECT_EQ(progress.take(), 1u);
  EXPECT_EQ(statesOf(progress), "dddrrrww");
  EXPECT_EQ(progress.take(), 2u);
  EXPECT_EQ(progress.take(), std::nullopt);
}

TEST(BatchProgress, TakesTheUnitsOfItsShareOnly) {
  BatchProgress progress({.rows = 8, .perPlate = 3}, {1, 2});
  EXPECT_EQ(progress.counts().waiting, 3u);
  progress.note(entry(0, kDone));
  EXPECT_EQ(progress.take(), 1u);
  EXPECT_EQ(progress.take(), std::nullopt);
  settle(progress, 1);
  EXPECT_EQ(progress.counts().done, 3u);
}

TEST(BatchProgress, RetriesFailedRowsOnRequest) {
  BatchProgress progress({.rows = 3});
  progress.note(entry(0, kFailed, "why"));
  progress.note(entry(1, kDone));
  progress.startRun();
  EXPECT_EQ(statesOf(progress), "fdw");
  progress.startRun(true);
  EXPECT_EQ(statesOf(progress), "wdw");
  EXPECT_EQ(progress.reason(0), "");
  EXPECT_EQ(progress.take(), 0u);
}

TEST(BatchProgress, RunningRowsWaitAgainAfterTheEnd) {
  BatchProgress progress({.rows = 4});
  progress.take();
  progress.take();
  settle(progress, 0);
  progress.endRun();
  EXPECT_EQ(statesOf(progress), "dwww");
  EXPECT_EQ(progress.take(), 1u);
}

TEST(BatchProgress, AUnitThatIsLostTwiceFails) {
  BatchProgress progress({.rows = 2});
  const auto unit = progress.take();
  EXPECT_EQ(progress.lose(unit), Loss::Retry);
  EXPECT_EQ(statesOf(progress), "ww");
  EXPECT_EQ(progress.take(), unit);
  EXPECT_EQ(progress.lose(unit), Loss::Fail);
  EXPECT_EQ(statesOf(progress), "rw") << "nothing else takes it meanwhile";
  settle(progress, 0, kFailed);
  EXPECT_EQ(progress.take(), 1u);
  progress.startRun(true);
  EXPECT_EQ(progress.take(), 0u);
  EXPECT_EQ(progress.lose(0), Loss::Retry) << "a new run forgets losses";
}

TEST(BatchProgress, StopsAfterTooManyLossesWithoutACarvedRow) {
  BatchProgress progress({.rows = 8});
  std::vector<Loss> losses;
  for (std::size_t unit = 0; unit < 4; ++unit) progress.take();
  for (std::size_t unit = 0; unit < 3; ++unit) losses.push_back(progress.lose(unit));
  settle(progress, 3);
  for (std::size_t unit = 4; unit < 8; ++unit) losses.push_back(progress.lose(unit));
  EXPECT_THAT(losses,
              ElementsAre(Loss::Retry, Loss::Retry, Loss::Retry, Loss::Retry, Loss::Retry, Loss::Retry, Loss::Stop));
}

TEST(BatchProgress, StopsIfNothingStarts) {
  BatchProgress progress({.rows = 3});
  EXPECT_EQ(progress.lose({}), Loss::Retry);
  EXPECT_EQ(progress.lose({}), Loss::Retry);
  EXPECT_EQ(progress.lose({}), Loss::Stop);
}

TEST(BatchProgress, EstimatesTheTimeLeftFromThePaceOfTheRun) {
  BatchProgress progress({.rows = 6});
  progress.note(entry(5, kDone));
  progress.take();
  EXPECT_EQ(progress.remainingMs(500), std::nullopt);
  settle(progress, 0);
  progress.take();
  EXPECT_EQ(progress.remainingMs(1000), 4000);
  progress.startRun();
  EXPECT_EQ(progress.remainingMs(10), std::nullopt);
}

TEST(BatchProgress, PagesThroughTheRowsOfOneStateOrOfAll) {
  BatchProgress progress({.rows = 10});
  for (const std::size_t row : {1, 4, 5, 9}) progress.note(entry(row, kFailed));
  EXPECT_THAT(progress.page(RowState::Failed, 1, 2), ElementsAre(4, 5));
  EXPECT_THAT(progress.page(RowState::Failed, 3, 5), ElementsAre(9));
  EXPECT_THAT(progress.page(std::nullopt, 8, 5), ElementsAre(8, 9));
  EXPECT_THAT(progress.page(RowState::Done, 0, 5), IsEmpty());
}

}  // namespace
}  // namespace qrelief
