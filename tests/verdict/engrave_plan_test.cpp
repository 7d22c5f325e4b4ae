// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/engrave_plan.h"

#include <gtest/gtest.h>

namespace qrelief {
namespace {

using Step = EngravePlan::Step;

/// Plays the host: says how many of 72 tries decoded the design or the print of each carving.
class EngravePlanTest : public testing::Test {
 protected:
  EngravePlanTest() {
    request_.code.text = "HELLO";
    request_.depth.preset = Preset::Shallow;
  }

  static Verdict verdictOf(bool reads, bool barelyPrints) {
    Verdict verdict;
    if (!reads) verdict.reads.failed.emplace_back("reads-not", std::initializer_list<const MessageValue*>{});
    if (barelyPrints) verdict.prints.level = Level::Barely;
    return verdict;
  }

  static PrintedEvidence print(int reads) {
    PrintedEvidence evidence;
    evidence.reading.count = {72, reads};
    return evidence;
  }

  void carve(bool reads) {
    ASSERT_EQ(plan_->step(), Step::Carve);
    presets_.emplace_back(presetName(plan_->request().depth.preset));
    plan_->carved(verdictOf(reads, false));
  }

  void printWith(int reads) {
    ASSERT_EQ(plan_->step(), Step::Print);
    plan_->printed(verdictOf(true, reads < 29), print(reads));
  }

  void begin(EngravePlan::Options options = {}) { plan_.emplace(request_, std::move(options)); }

  void expectDelivery(int attempt, const char* preset) const {
    EXPECT_EQ(plan_->step(), Step::Deliver);
    EXPECT_EQ(plan_->attempt(), attempt);
    EXPECT_STREQ(presetName(plan_->request().depth.preset), preset);
  }

  EngraveRequest request_;
  std::optional<EngravePlan> plan_;
  std::vector<std::string> presets_;  // of the carvings so far
};

TEST_F(EngravePlanTest, DeliversTheRequestedCarvingIfItsPrintDecodes) {
  begin();
  EXPECT_TRUE(plan_->expectsPrint());
  EXPECT_EQ(plan_->change(), std::nullopt);
  carve(true);
  printWith(29);
  expectDelivery(0, "shallow");
}

TEST_F(EngravePlanTest, CarvesDeeperUntilTheDesignDecodes) {
  begin();
  carve(false);
  EXPECT_EQ(plan_->change(), (SettingChange{"preset", "balanced"}));
  EXPECT_FALSE(plan_->expectsPrint());
  EXPECT_EQ(plan_->kept(), 0);
  carve(false);
  carve(true);
  EXPECT_EQ(plan_->kept(), 2);
  printWith(72);
  expectDelivery(2, "robust");
  EXPECT_EQ(presets_, (std::vector<std::string>{"shallow", "balanced", "robust"}));
}

TEST_F(EngravePlanTest, ReturnsToTheRequestedCarvingIfNoDeeperOneDecodes) {
  begin();
  for (int attempt = 0; attempt < 3; ++attempt) carve(false);
  EXPECT_EQ(plan_->step(), Step::Print);
  EXPECT_EQ(plan_->attempt(), 0);
  plan_->printed(verdictOf(false, true), print(20));
  expectDelivery(0, "shallow");
}

TEST_F(EngravePlanTest, CarvesDeeperWhileThePrintBarelyDecodes) {
  begin();
  carve(true);
  printWith(20);
  EXPECT_TRUE(plan_->expectsPrint());
  carve(true);
  EXPECT_EQ(plan_->step(), Step::Print);
  EXPECT_EQ(plan_->attempt(), 1);
  printWith(28);
  EXPECT_EQ(plan_->kept(), 0) << "no print has decoded yet";
  carve(true);
  printWith(29);
  expectDelivery(2, "robust");
}

TEST_F(EngravePlanTest, ReturnsToTheRequestedCarvingIfNoDeeperPrintDecodes) {
  begin();
  carve(true);
  printWith(20);
  carve(true);
  printWith(20);
  carve(true);
  printWith(20);
  expectDelivery(0, "shallow");
}

TEST_F(EngravePlanTest, ReturnsToTheKeptCarvingIfADeeperOneSpoilsTheDesignOrCannotBeCarved) {
  for (const bool isCarved : {true, false}) {
    begin();
    carve(true);
    printWith(20);
    if (isCarved)
      carve(false);
    else
      plan_->notCarved();
    expectDelivery(0, "shallow");
  }
}

TEST_F(EngravePlanTest, PrintsTheRequestedCarvingIfADeeperDesignCannotBeCarved) {
  begin();
  carve(false);
  plan_->notCarved();
  EXPECT_EQ(plan_->step(), Step::Print);
  EXPECT_EQ(plan_->attempt(), 0);
}

TEST_F(EngravePlanTest, ChangesNothingThatIsFixedAndNothingAtAllIfItMayNot) {
  for (const EngravePlan::Options& options :
       {EngravePlan::Options{.fixed = {"preset"}}, EngravePlan::Options{.mayChange = false}}) {
    begin(options);
    carve(false);
    EXPECT_EQ(plan_->step(), Step::Print);
    printWith(20);
    expectDelivery(0, "shallow");
  }
  begin({.fixed = {"size"}});
  carve(false);
  EXPECT_EQ(plan_->step(), Step::Carve);
}

TEST_F(EngravePlanTest, LooksAtNoPrintIfToldSoOrWithoutAProcess) {
  begin({.looksAtPrint = false});
  EXPECT_FALSE(plan_->expectsPrint());
  carve(true);
  expectDelivery(0, "shallow");
  request_.print.process.reset();
  begin();
  carve(true);
  expectDelivery(0, "shallow");
}

/// Plans with an open mark: a shadow first, then an inlay, then paint.
class OpenMarkTest : public EngravePlanTest {
 protected:
  OpenMarkTest() {
    request_.marking.isOpen = true;
    request_.depth.keepPreset = true;
  }

  void expectCarving(Mark mark) const {
    EXPECT_EQ(plan_->step(), Step::Carve);
    EXPECT_EQ(plan_->request().marking.mark, mark);
  }
  void expectMark(Mark mark) const {
    EXPECT_EQ(plan_->step(), Step::Deliver);
    EXPECT_EQ(plan_->request().marking.mark, mark);
  }
};

TEST_F(OpenMarkTest, StaysWithAShadowThatPrintsWell) {
  begin();
  expectCarving(Mark::Shadow);
  carve(true);
  printWith(40);
  expectMark(Mark::Shadow);
}

TEST_F(OpenMarkTest, InlaysACodeWhoseShadowPrintsBadly) {
  begin();
  carve(true);
  printWith(20);
  expectCarving(Mark::Inlay);
  EXPECT_EQ(plan_->change(), (SettingChange{"mark", "inlay"}));
  EXPECT_TRUE(plan_->expectsPrint());
  carve(true);
  printWith(60);
  expectMark(Mark::Inlay);
}

TEST_F(OpenMarkTest, PaintsWhereAnInlayIsNoBetter) {
  begin();
  carve(true);
  printWith(20);
  plan_->notCarved();
  expectCarving(Mark::Paint);
  carve(true);
  printWith(60);
  expectMark(Mark::Paint);
}

TEST_F(OpenMarkTest, TriesOnlyMarksThatTheOutputHolds) {
  begin({.otherMarks = {Mark::Inlay}});
  carve(true);
  printWith(20);
  expectCarving(Mark::Inlay);
  plan_->notCarved();
  expectMark(Mark::Shadow);
  begin({.otherMarks = {}});
  carve(true);
  printWith(20);
  expectMark(Mark::Shadow);
}

TEST_F(OpenMarkTest, KeepsTheShadowIfNoColourIsBetter) {
  begin();
  carve(true);
  printWith(20);
  carve(true);
  printWith(20);
  carve(true);
  printWith(20);
  expectMark(Mark::Shadow);
  EXPECT_EQ(plan_->attempt(), 0);
}

TEST_F(OpenMarkTest, GoesOnWhereNoShadowCanBeCarved) {
  begin();
  EXPECT_TRUE(plan_->mayFail());
  plan_->notCarved();
  expectCarving(Mark::Inlay);
  carve(true);
  printWith(60);
  expectMark(Mark::Inlay);
}

TEST_F(OpenMarkTest, DeliversNothingIfNoMarkCanBeCarved) {
  begin();
  plan_->notCarved();
  plan_->notCarved();
  plan_->notCarved();
  EXPECT_EQ(plan_->step(), Step::Deliver);
  EXPECT_EQ(plan_->attempt(), 0);
}

TEST_F(OpenMarkTest, TriesColoursByTheirDesignsIfNoPrintIsLookedAt) {
  begin({.looksAtPrint = false});
  carve(false);
  expectCarving(Mark::Inlay);
  carve(true);
  expectMark(Mark::Inlay);
}

}  // namespace
}  // namespace qrelief
