// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/engrave_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace qrelief {
namespace {

using Step = EngravePlan::Step;
using testing::ElementsAre;

/// Plays the host: says how many of 72 tries decoded the design or the print of each carving.
class EngravePlanTest : public testing::Test {
 protected:
  EngravePlanTest() {
    request_.code.text = "HELLO";
    request_.depth.preset = Preset::Shallow;
    request_.placement.sizeMode = SizeMode::Fixed;
    request_.placement.sizeMm = 20;
  }

  static Verdict verdictOf(bool reads, bool barelyPrints) {
    Verdict verdict;
    if (!reads) verdict.reads.failed.emplace_back("reads-not", std::initializer_list<const MessageValue*>{});
    if (barelyPrints) verdict.prints.level = Level::Barely;
    return verdict;
  }

  /// Returns the verdict on a print that so many of 72 tries decoded.
  static Verdict verdictOfPrint(int reads) {
    Verdict verdict = verdictOf(true, reads < 29);
    if (reads >= 12) return verdict;
    verdict.prints.level = Level::Bad;
    verdict.prints.failed.emplace_back("unreadable-as-printed", std::initializer_list<const MessageValue*>{});
    return verdict;
  }

  static Error noSolution(const char* code = "no-spot") { return {ErrorKind::NoSolution, Message(code, {})}; }

  static PrintedEvidence print(int reads) {
    PrintedEvidence evidence;
    evidence.reading.count = {72, reads};
    return evidence;
  }

  void carve(bool reads) {
    ASSERT_EQ(plan_->step(), Step::Carve);
    presets_.emplace_back(presetName(plan_->request().depth.preset));
    plan_->carved(verdictOf(reads, false), {72, reads ? 72 : 0}, symbolMm_);
  }

  void printWith(int reads) {
    ASSERT_EQ(plan_->step(), Step::Print);
    plan_->printed(verdictOfPrint(reads), print(reads));
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
  double symbolMm_ = 20;              // of the next carving
};

TEST_F(EngravePlanTest, DeliversTheRequestedCarvingIfItsPrintDecodes) {
  begin();
  EXPECT_TRUE(plan_->expectsPrint());
  EXPECT_TRUE(plan_->changes().empty());
  carve(true);
  printWith(29);
  expectDelivery(0, "shallow");
}

TEST_F(EngravePlanTest, CarvesDeeperUntilTheDesignDecodes) {
  begin();
  carve(false);
  EXPECT_THAT(plan_->changes(), ElementsAre(SettingChange{"preset", "balanced"}));
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
      plan_->notCarved(noSolution());
    expectDelivery(0, "shallow");
  }
}

TEST_F(EngravePlanTest, PrintsTheRequestedCarvingIfADeeperDesignCannotBeCarved) {
  begin();
  carve(false);
  plan_->notCarved(noSolution());
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
  EXPECT_THAT(plan_->changes(), ElementsAre(SettingChange{"mark", "inlay"}));
  EXPECT_TRUE(plan_->expectsPrint());
  carve(true);
  printWith(60);
  expectMark(Mark::Inlay);
}

TEST_F(OpenMarkTest, PaintsWhereAnInlayIsNoBetter) {
  begin();
  carve(true);
  printWith(20);
  plan_->notCarved(noSolution());
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
  plan_->notCarved(noSolution());
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
  plan_->notCarved(noSolution());
  expectCarving(Mark::Inlay);
  carve(true);
  printWith(60);
  expectMark(Mark::Inlay);
}

TEST_F(OpenMarkTest, PaintsATextWhereWallsTakeNoLetters) {
  request_.code.content = Content::Text;
  begin();
  plan_->notCarved(noSolution("text-too-deep"));
  expectCarving(Mark::Inlay);
  plan_->notCarved(noSolution("text-too-deep"));
  expectCarving(Mark::Paint);
  plan_->carved(verdictOf(true, false), {}, symbolMm_);
  expectMark(Mark::Paint);
}

TEST_F(OpenMarkTest, KeepsATextThatPrintsWellAsAShadow) {
  request_.code.content = Content::Text;
  begin();
  plan_->carved(verdictOf(true, false), {}, symbolMm_);
  expectMark(Mark::Shadow);
}

TEST_F(OpenMarkTest, DeliversNothingIfNoMarkCanBeCarved) {
  begin();
  plan_->notCarved(noSolution());
  plan_->notCarved(noSolution());
  plan_->notCarved(noSolution());
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

/// Plans with settings that the user left open.
class OpenSettingsTest : public EngravePlanTest {
 protected:
  OpenSettingsTest() {
    request_ = defaultRequest();
    request_.code.text = "HELLO";
  }

  void carveAndPrint(int reads) {
    carve(true);
    printWith(reads);
  }
  inline static const SettingChange kLarger{"maxSizeMm", "80"};
};

TEST_F(OpenSettingsTest, AFirstCarvingThatPassesCostsNothingMore) {
  for (const int reads : {29, 72}) {
    begin({.offersMarks = true});
    carveAndPrint(reads);
    expectDelivery(0, "balanced");
    EXPECT_EQ(plan_->tried().size(), 1u);
    EXPECT_TRUE(plan_->tried().front().passed);
  }
}

TEST_F(OpenSettingsTest, ATextWithStrokesTooThinIsMadeLargerAndNothingElse) {
  request_.code.content = Content::Text;
  symbolMm_ = request_.placement.maxSizeMm;
  begin({.offersMarks = true});
  EXPECT_FALSE(plan_->expectsPrint());
  Verdict tooThin;
  tooThin.prints.level = Level::Bad;
  tooThin.prints.failed.emplace_back("text-too-fine", std::initializer_list<const MessageValue*>{});
  plan_->carved(tooThin, {}, symbolMm_);
  ASSERT_EQ(plan_->step(), Step::Carve);
  EXPECT_THAT(plan_->changes(), ElementsAre(kLarger));
  plan_->carved(tooThin, {}, 60);
  EXPECT_EQ(plan_->step(), Step::Deliver);
  EXPECT_EQ(plan_->tried().size(), 2u);
}

TEST_F(OpenSettingsTest, ACodeThatDoesNotReadAsPrintedIsMadeLarger) {
  symbolMm_ = request_.placement.maxSizeMm;
  begin();
  carveAndPrint(0);
  EXPECT_THAT(plan_->changes(), ElementsAre(kLarger));
  EXPECT_EQ(plan_->request().placement.maxSizeMm, 80);
  EXPECT_TRUE(plan_->expectsPrint());
  symbolMm_ = 68;
  carveAndPrint(42);
  EXPECT_EQ(plan_->step(), Step::Deliver);
  EXPECT_EQ(plan_->attempt(), 1);
  ASSERT_EQ(plan_->tried().size(), 2u);
  EXPECT_EQ(plan_->tried()[0].printed, (ReadingCount{72, 0}));
  EXPECT_FALSE(plan_->tried()[0].passed);
  EXPECT_EQ(plan_->tried()[1].printed, (ReadingCount{72, 42}));
  EXPECT_EQ(plan_->tried()[1].symbolMm, 68);
  EXPECT_TRUE(plan_->tried()[1].passed);
}

TEST_F(OpenSettingsTest, ALargerCodeWhosePrintBarelyDecodesIsCarvedDeeper) {
  symbolMm_ = request_.placement.maxSizeMm;
  begin();
  carveAndPrint(0);
  carveAndPrint(23);
  EXPECT_THAT(plan_->changes(), ElementsAre(kLarger, SettingChange{"preset", "robust"}));
  EXPECT_EQ(plan_->kept(), 1);
  carveAndPrint(40);
  expectDelivery(2, "robust");
}

TEST_F(OpenSettingsTest, SettingsThatTheUserGaveAreNotChanged) {
  begin({.offersMarks = true, .chosen = {"size", "ecc", "mark"}});
  carveAndPrint(0);
  expectDelivery(0, "balanced");
}

TEST_F(OpenSettingsTest, LessErrorCorrectionIsTriedIfTheSymbolIsSmaller) {
  request_.code.text = "thirty characters without link";  // version 3 at M, version 2 at L
  begin();
  carveAndPrint(0);
  EXPECT_THAT(plan_->changes(), ElementsAre(SettingChange{"ecc", "L"}));
  carveAndPrint(30);
  EXPECT_EQ(plan_->attempt(), 1);
}

TEST_F(OpenSettingsTest, ALinkIsWrittenInCapitalsIfTheSymbolIsSmaller) {
  request_.code.text = "https://example.com/abcdefghij";  // version 3, in capitals version 2, also at L
  const SettingChange capitals{"text", "HTTPS://EXAMPLE.COM/abcdefghij"};
  begin({.chosen = {"text"}});
  carveAndPrint(0);
  EXPECT_THAT(plan_->changes(), ElementsAre(capitals));
  EXPECT_EQ(plan_->request().code.text, capitals.value);
  carveAndPrint(0);
  expectDelivery(0, "balanced");
}

TEST_F(OpenSettingsTest, LessErrorCorrectionIsTriedForALinkInCapitals) {
  request_.code.text = "https://example.com/ab";  // version 2, and in capitals or at L, too; with both, version 1
  begin();
  carveAndPrint(0);
  EXPECT_THAT(plan_->changes(),
              ElementsAre(SettingChange{"ecc", "L"}, SettingChange{"text", "HTTPS://EXAMPLE.COM/ab"}));
}

TEST_F(OpenSettingsTest, AFixedTextKeepsItsCase) {
  request_.code.text = "https://example.com/abcdefghij";
  begin({.fixed = {"text"}});
  carveAndPrint(0);
  EXPECT_THAT(plan_->changes(), ElementsAre(SettingChange{"ecc", "L"}));
}

TEST_F(OpenSettingsTest, RemediesAreTriedWhereNothingCouldBeCarved) {
  request_.code.text = "thirty characters without link";
  begin();
  plan_->notCarved(noSolution());
  EXPECT_THAT(plan_->changes(), ElementsAre(SettingChange{"ecc", "L"}));
  carveAndPrint(30);
  EXPECT_EQ(plan_->attempt(), 1);
  ASSERT_TRUE(plan_->tried()[0].failure);
  EXPECT_EQ(plan_->tried()[0].failure->code, "no-spot");
}

TEST_F(OpenSettingsTest, NoChangeHelpsARequestThatMakesNoSense) {
  begin({.offersMarks = true});
  plan_->notCarved({ErrorKind::BadUsage, Message("no-spot", {})});
  EXPECT_EQ(plan_->step(), Step::Deliver);
}

TEST_F(OpenSettingsTest, ThinWallsTakeNoLargerShadowEither) {
  request_.marking.isOpen = true;
  begin();
  plan_->notCarved(noSolution("nothing-can-be-carved"));
  EXPECT_THAT(plan_->changes(), ElementsAre(SettingChange{"mark", "inlay"}));
}

TEST_F(OpenSettingsTest, EachAttemptGoesToItsOwnSpotIfTheCentreIsOpen) {
  symbolMm_ = request_.placement.maxSizeMm;
  begin({.mayMove = true});
  const auto place = [&](double x) {
    ASSERT_EQ(plan_->step(), Step::Place);
    PlacementRequest placement = plan_->request().placement;
    placement.centreMm = {x, 0, 0};
    plan_->placed(placement);
    EXPECT_EQ(plan_->request().placement.centreMm.x, x);
  };
  place(1);
  carveAndPrint(0);
  place(2);
  EXPECT_EQ(plan_->request().placement.maxSizeMm, 80);
  carveAndPrint(60);
  EXPECT_EQ(plan_->step(), Step::Deliver);
  EXPECT_EQ(plan_->request().placement.centreMm.x, 2);
  EXPECT_EQ(plan_->tried()[0].centreMm, Vec3(1, 0, 0));
}

TEST_F(OpenSettingsTest, OtherMarksKeepTheChangesThatMadeModulesLarger) {
  request_.marking.isOpen = true;
  symbolMm_ = request_.placement.maxSizeMm;
  begin();
  carveAndPrint(0);
  carveAndPrint(0);
  EXPECT_THAT(plan_->changes(), ElementsAre(SettingChange{"mark", "inlay"}, kLarger));
  carveAndPrint(72);
  EXPECT_EQ(plan_->step(), Step::Deliver);
  EXPECT_EQ(plan_->attempt(), 2);
}

TEST_F(OpenSettingsTest, OtherMarksAreOfferedButNotDelivered) {
  begin({.offersMarks = true});
  carveAndPrint(0);
  EXPECT_THAT(plan_->changes(), ElementsAre(SettingChange{"mark", "inlay"}));
  carveAndPrint(72);
  expectDelivery(0, "balanced");
  ASSERT_EQ(plan_->tried().size(), 2u);
  EXPECT_TRUE(plan_->tried()[1].isOffer);
  ASSERT_NE(passedOffer(plan_->tried()), nullptr);
}

TEST_F(OpenSettingsTest, RemediesThatWereTriedInVainAreNotOffered) {
  const auto remedy = [](std::vector<SettingChange> changes) {
    return Remedy{Message("remedy-turn", {}), std::move(changes)};
  };
  Verdict verdict = verdictOfPrint(0);
  verdict.prints.remedies = {remedy({kLarger}), remedy({kLarger, {"nozzleMm", "0.25"}}), remedy({})};
  std::vector<TriedCarving> tried(3);
  tried[1].changes = {kLarger};
  tried[2].changes = {{"mark", "inlay"}, kLarger};
  tried[2].isOffer = tried[2].passed = true;
  tried[2].printed = {72, 70};
  const std::vector<Remedy> left = withRemediesLeft(verdict, tried).prints.remedies;
  ASSERT_EQ(left.size(), 3u);
  EXPECT_THAT(left[0].changes, ElementsAre(SettingChange{"mark", "inlay"}));
  EXPECT_EQ(left[1].changes.size(), 2u) << "only one of both was tried";
  EXPECT_TRUE(left[2].changes.empty());
  const Error error = withOffer(noSolution(), tried);
  EXPECT_EQ(error.message.code, "mark-instead");
  EXPECT_EQ(withOffer(noSolution(), {}).message.code, "no-spot");
}

}  // namespace
}  // namespace qrelief
