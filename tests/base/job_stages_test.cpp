// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/job_stages.h"

#include <gmock/gmock.h>

#include "message_codes/pipeline.h"
#include "message_codes/stages.h"
#include "support/follow_job.h"

namespace qrelief {
namespace {

using testing::ElementsAre;

/// A job whose stages return given outcomes.
struct Errand {
  JobStages<Errand> stages;
  std::vector<StageStep> outcomes = {};
  std::size_t next = 0;

  Progress progress() const { return stages.progress(); }
  Result<Progress> advance() { return stages.advance(*this); }

  Result<StageStep> once() { return kStageDone; }
  Result<StageStep> often() { return outcomes[next++]; }
  Result<StageStep> refuse() { return badInput(message<"no-triangle">()); }
  Result<StageStep> addOne() {
    stages.add({message<"printing">(), 30, &Errand::once});
    return kStageDone;
  }
};

TEST(JobStages, TheFractionIsTheWeightsOfFinishedStagesAndTheShareOfTheCurrentOne) {
  Errand errand{{{message<"measuring-surface">(), 10, &Errand::once},
                 {message<"finding-depth">(), 60, &Errand::often},
                 {message<"carving-mesh">(), 30, &Errand::once}},
                {{0.5}, {0.75}, kStageDone}};
  std::vector<double> fractions = {errand.progress().fraction};
  while (!errand.progress().done) fractions.push_back(errand.advance()->fraction);
  EXPECT_THAT(fractions, ElementsAre(0, 0.1, 0.4, 0.55, 0.7, 1));
}

TEST(JobStages, AShareThatFallsOrExceedsOneKeepsTheFractionRisingBelowOne) {
  Errand errand{{{message<"finding-depth">(), 1, &Errand::often}}, {{0.5}, {0.25}, {7}, {-1}, kStageDone}};
  EXPECT_THAT(followJob(errand), ElementsAre("finding-depth"));
}

TEST(JobStages, StagesThatAreNotNeededAreLeftOut) {
  Errand errand{{{message<"finding-direction-and-size">(), 5, &Errand::refuse, false},
                 {message<"measuring-surface">(), 10, &Errand::once},
                 {message<"printing">(), 10, &Errand::refuse, false},
                 {message<"looking-at-result">(), 10, &Errand::once}}};
  EXPECT_EQ(errand.progress().stage.code, "measuring-surface");
  EXPECT_EQ(errand.advance()->fraction, 0.5);
  EXPECT_TRUE(errand.advance()->done);
}

TEST(JobStages, AStageAddedOnTheWayComesLast) {
  Errand errand{{{message<"finding-depth">(), 60, &Errand::once}, {message<"testing-spots">(), 10, &Errand::addOne}}};
  EXPECT_THAT(followJob(errand), ElementsAre("finding-depth", "testing-spots", "printing"));
}

TEST(JobStages, AnErrorEndsTheJobAndSoDoesItsLastStage) {
  Errand failing{{{message<"checking-solid">(), 1, &Errand::refuse}}};
  EXPECT_EQ(failing.advance().error().message.code, "no-triangle");
  Errand finished{{{message<"checking-solid">(), 1, &Errand::once}}};
  EXPECT_TRUE(finished.advance()->done);
  EXPECT_EQ(finished.advance().error().message.code, "advance-after-done");
}

}  // namespace
}  // namespace qrelief
