// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/verdict.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/engrave.h"
#include "qr/symbol.h"
#include "support/shapes.h"
#include "verdict/remedies.h"

namespace qrelief {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> settingsOf(const std::vector<Remedy>& remedies) {
  std::vector<std::string> settings;
  for (const Remedy& remedy : remedies) {
    std::string changes;
    for (const SettingChange& change : remedy.changes)
      changes += (changes.empty() ? "" : " ") + change.setting + "=" + change.value;
    settings.push_back(changes);
  }
  return settings;
}

std::vector<std::string> codesOf(const std::vector<Message>& messages) {
  std::vector<std::string> codes;
  for (const Message& one : messages) codes.push_back(one.code);
  return codes;
}

/// Returns a carving of every dark submodule to `depthMm`, in a model that has room for larger ones.
EngraveResult carved(const EngraveRequest& request, double symbolMm, double depthMm) {
  EngraveResult result;
  result.mesh = shapes::box({60, 60, 20});
  result.symbol = *encodeSymbol("HELLO", {.version = 1});
  const SubmoduleMask mask = submodulesToCarve(
      result.symbol, request.code.ownPattern.value_or(request.code.modulePattern.value_or(ModulePattern::ThickPlus)),
      request.code.finderPattern.value_or(FinderPattern::ThickPlusSharp));
  result.depths = {mask.rows(), symbolMm, {}};
  for (const std::uint8_t one : mask) result.depths.depthMm.push_back(one ? depthMm : 0);
  result.placement.symbolMm = symbolMm;
  result.placement.moduleMm = symbolMm / result.symbol.size;
  result.placement.guaranteedMm = symbolMm;
  const int edge = kSubmodulesPerModule * (result.symbol.size + 2 * kQuietZoneModules);
  result.luminance = {edge, edge, 1};
  result.solidity.triangles = 1000;
  result.solidity.volumeMm3 = 1000;
  return result;
}

/// Returns the number of tries that a message calls needed; -1: none.
double neededIn(const Message& message) {
  for (const MessageValue& value : message.values)
    if (value.name == "needed") return value.numbers[0];
  return -1;
}

ReadingEvidence evidence(int reads) {
  std::vector<std::string> texts(72);
  std::fill_n(texts.begin(), reads, "HELLO");
  return evidenceOf(texts, "HELLO");
}

TEST(ReadingCount, NeedsTwoInFiveTriesRoundedUp) {
  EXPECT_EQ(ReadingCount::needed(72), 29);  // 28.8
  EXPECT_EQ(ReadingCount::needed(5), 2);
  EXPECT_EQ(ReadingCount::needed(192), 77);  // 76.8; in whole per cent 76 and 77 would both be 40
  EXPECT_FALSE((ReadingCount{72, 28}).enough());
  EXPECT_TRUE((ReadingCount{72, 29}).enough());
  EXPECT_FALSE(ReadingCount{}.enough());
}

TEST(EvidenceOf, CountsTheWantedTextAndListsItFirst) {
  const ReadingEvidence reading = evidenceOf({"", "OTHER", "HELLO", "HELLO", ""}, "HELLO");
  EXPECT_EQ(reading.count, (ReadingCount{5, 2}));
  EXPECT_EQ(reading.text, "HELLO");
  EXPECT_EQ(evidenceOf({"", "OTHER", ""}, "HELLO").text, "OTHER");
  EXPECT_EQ(evidenceOf({"", ""}, "HELLO").text, "");
}

class VerdictTest : public testing::Test {
 protected:
  VerdictTest() {
    request_.code.text = "HELLO";
    request_.placement.sizeMode = SizeMode::Free;
  }
  Verdict judged(int reads, double symbolMm = 30, double depthMm = 0.5) {
    return judge(request_, carved(request_, symbolMm, depthMm), evidence(reads));
  }
  EngraveRequest request_;
};

TEST_F(VerdictTest, ACodeThatDoesNotPassIsNeverSaidToRead) {
  EXPECT_TRUE(judged(29).reads.passed());
  for (const bool underLamp : {false, true}) {
    if (underLamp) request_.depth.lights = {{}};
    for (const int reads : {1, 28}) {
      const Aspect aspect = judged(reads).reads;
      EXPECT_FALSE(aspect.passed());
      EXPECT_EQ(aspect.level, Level::Bad);
      EXPECT_EQ(aspect.summary.code, "reads-not-reliably");
    }
    EXPECT_EQ(judged(0).reads.level, Level::Bad);
    EXPECT_EQ(judged(0).reads.summary.code, "reads-not");
  }
}

TEST_F(VerdictTest, ReportsAWeakGradeAndPasses) {
  const Verdict verdict = judged(72);  // its light and dark modules are equally bright
  EXPECT_EQ(verdict.reads.level, Level::Barely);
  EXPECT_TRUE(verdict.reads.passed());
  EXPECT_EQ(verdict.reads.summary.code, "barely-reads-as");
  EXPECT_EQ(verdict.reads.reasons.back().code, "graded-weak");
}

TEST_F(VerdictTest, TriesTheNextDeeperPresetUnlessTheRequestKeepsIts) {
  const auto preset = [](const char* name) { return SettingChange{"preset", name}; };
  EXPECT_EQ(changeToTryNext(request_, judged(28)), preset("robust"));
  EXPECT_EQ(changeToTryNext(request_, judged(29)), std::nullopt);
  request_.depth.preset = Preset::Shallow;
  EXPECT_EQ(changeToTryNext(request_, judged(0)), preset("balanced"));
  request_.depth.keepPreset = true;
  EXPECT_EQ(changeToTryNext(request_, judged(0)), std::nullopt);
  request_ = {};
  request_.code.text = "HELLO";
  request_.depth.contrast = 0.2;
  EXPECT_EQ(changeToTryNext(request_, judged(0)), std::nullopt);
  request_ = {};
  request_.code.text = "HELLO";
  request_.depth.preset = Preset::Robust;
  EXPECT_EQ(changeToTryNext(request_, judged(0)), std::nullopt);
}

TEST_F(VerdictTest, TriesTheNextDeeperPresetIfThePrintBarelyDecodes) {
  const auto next = [&](int reads, double facingDeg = 0) {
    const PrintedEvidence printed{evidence(reads), {}, facingDeg};
    const Verdict verdict = judge(request_, carved(request_, 30, 0.5), evidence(72), &printed);
    return changeToTryNext(request_, verdict, &printed);
  };
  request_.depth.carveFor = CarveFor::Print;
  EXPECT_EQ(next(29), std::nullopt);
  EXPECT_EQ(next(29, 120), std::nullopt) << "deeper pockets do not turn a code that hangs";
  EXPECT_EQ(next(28), (SettingChange{"preset", "robust"}));
  EXPECT_EQ(next(11), std::nullopt) << "too few reads to hope for";
  request_.depth.keepPreset = true;
  EXPECT_EQ(next(28), std::nullopt);
}

TEST_F(VerdictTest, TriesCarvingForTheDesignBeforeADeeperPreset) {
  request_.depth.carveFor = CarveFor::Print;
  EXPECT_EQ(changeToTryNext(request_, judged(29)), std::nullopt);
  for (const bool keepPreset : {false, true}) {
    request_.depth.keepPreset = keepPreset;
    EXPECT_EQ(changeToTryNext(request_, judged(28)), (SettingChange{"carveFor", "design"}));
  }
  request_.depth.keepPreset = false;
  apply({"carveFor", "design"}, request_);
  EXPECT_EQ(changeToTryNext(request_, judged(28)), (SettingChange{"preset", "robust"}));
}

TEST_F(VerdictTest, ReadingRemediesAreDepthSizeAndAnotherSpot) {
  EXPECT_THAT(settingsOf(judged(0).reads.remedies), ElementsAre("preset=robust", "size=best", ""));
  request_.depth.contrast = 0.2;
  request_.placement.sizeMode = SizeMode::Best;
  EXPECT_THAT(settingsOf(judged(0).reads.remedies), ElementsAre("contrast=", ""));
  request_.placement.rotateDeg = 20;
  EXPECT_THAT(settingsOf(judged(0).reads.remedies), ElementsAre("contrast=", "rotateDeg=0", ""));
  request_.placement.maxSizeMm = 30;  // the bound limits the size
  EXPECT_THAT(settingsOf(judged(0).reads.remedies), ElementsAre("contrast=", "maxSizeMm=38", ""));
  request_.depth.objective = DepthObjective::OneLight;
  EXPECT_EQ(settingsOf(judged(0).reads.remedies).front(), "objective=contrast");
}

TEST_F(VerdictTest, PrintingRemediesAreTheFirstCommonOnesThatWouldDo) {
  request_.code.modulePattern = ModulePattern::Square;
  request_.code.finderPattern = FinderPattern::AsModules;
  const Verdict verdict = judged(72, 21 * 0.7);  // modules of 0.7 mm: square needs 0.9 mm with a nozzle of 0.4 mm
  EXPECT_EQ(verdict.prints.level, Level::Barely);
  EXPECT_TRUE(verdict.prints.passed());
  EXPECT_THAT(settingsOf(verdict.prints.remedies), ElementsAre("size=best", "pattern=thick-plus", "nozzleMm=0.3", ""));
  request_.code.ownPattern = ModulePattern::Square;
  request_.code.modulePattern.reset();
  EXPECT_THAT(settingsOf(judged(72, 21 * 0.7).prints.remedies), testing::Contains("pattern=thick-plus"));
  const Verdict shallow = judged(72, 40, 0.15);  // one and a half layers of 0.1 mm
  EXPECT_THAT(settingsOf(shallow.prints.remedies), ElementsAre("preset=robust", "layerMm=0.06", ""));
}

TEST_F(VerdictTest, ALargerLimitIsOfferedOnlyIfTheModelHasRoom) {
  request_.placement.maxSizeMm = 30;
  EngraveResult result = carved(request_, 30, 0.5);
  EXPECT_THAT(settingsOf(readingRemedies(request_, result)), testing::Contains("maxSizeMm=38"));
  const double diagonalMm = std::sqrt(2) * 38 * 29 / 21;  // of the square with its quiet zone
  result.mesh = shapes::box({diagonalMm + 0.1, 0.1, 0.1});
  EXPECT_THAT(settingsOf(readingRemedies(request_, result)), testing::Contains("maxSizeMm=38"));
  result.mesh = shapes::box({diagonalMm - 0.1, 0.1, 0.1});
  EXPECT_THAT(settingsOf(readingRemedies(request_, result)), ElementsAre("preset=robust", ""));
}

TEST_F(VerdictTest, AFinerNozzleComesWithLayersThatItCanLay) {
  request_.code.modulePattern = ModulePattern::Square;
  request_.code.finderPattern = FinderPattern::AsModules;
  const auto ofModules = [&](double moduleMm) { return settingsOf(judged(72, 21 * moduleMm).prints.remedies); };
  EXPECT_THAT(ofModules(0.7), testing::Contains("nozzleMm=0.3")) << "layers of 0.2 mm are two thirds of it";
  EXPECT_THAT(ofModules(0.46), testing::Contains("nozzleMm=0.2 layerMm=0.12"));
  request_.print.printer.layerMm = 0.1;
  EXPECT_THAT(ofModules(0.46), testing::Contains("nozzleMm=0.2"));
}

TEST_F(VerdictTest, APrintThatDoesNotReadFails) {
  const auto printed = [&](int reads, double facingDeg, double symbolMm = 30) {
    const PrintedEvidence evidenceOfPrint{evidence(reads), "fdm-0.4/0.2", facingDeg};
    return judge(request_, carved(request_, symbolMm, 0.5), evidence(72), &evidenceOfPrint).prints;
  };
  const auto facing = [](const Aspect& aspect) { return aspect.summary.values.front().cause.front().code; };
  const Aspect good = printed(29, 0);
  EXPECT_EQ(good.level, Level::Good);
  EXPECT_EQ(good.summary.code, "reads-as-printed");
  EXPECT_EQ(facing(good), "facing-up");
  ASSERT_EQ(good.reasons.size(), 1u) << "how many tries, and no advice";
  const Aspect barely = printed(28, 80, 21 * 0.3);
  EXPECT_EQ(barely.level, Level::Barely);
  EXPECT_EQ(barely.summary.code, "barely-reads-as-printed");
  EXPECT_EQ(facing(barely), "facing-aside");
  EXPECT_GT(barely.reasons.size(), 1u) << "advice, too";
  EXPECT_EQ(settingsOf(barely.remedies).front(), "size=best") << "modules of 0.3 mm: depth does not help";
  EXPECT_EQ(printed(12, 0).level, Level::Barely);
  EXPECT_EQ(neededIn(printed(12, 0).reasons.front()), 12) << "the least number that passes";
  const Aspect hanging = printed(69, 180);
  EXPECT_EQ(hanging.level, Level::Barely);
  EXPECT_EQ(hanging.summary.code, "reads-as-printed-hanging");
  const Aspect bad = printed(11, 45);
  EXPECT_EQ(settingsOf(bad.remedies).front(), "carveFor=print");
  request_.depth.carveFor = CarveFor::Print;
  EXPECT_EQ(settingsOf(printed(11, 45).remedies).front(), "preset=robust") << "that is done already";
  request_.depth.carveFor = CarveFor::Design;
  request_.depth.lights = {{}};
  EXPECT_EQ(settingsOf(printed(11, 45).remedies).front(), "light=") << "under the sky alone codes read best";
  EXPECT_EQ(settingsOf(printed(11, 45).remedies).at(1), "carveFor=print");
  request_.depth.objective = DepthObjective::OneLight;
  EXPECT_EQ(settingsOf(printed(11, 45).remedies).front(), "objective=contrast light=");
  request_.depth.lights.clear();
  EXPECT_EQ(settingsOf(printed(11, 45).remedies).front(), "objective=contrast");
  request_.depth.objective = DepthObjective::Contrast;
  EXPECT_EQ(bad.level, Level::Bad);
  EXPECT_EQ(bad.summary.code, "reads-not-as-printed");
  EXPECT_EQ(facing(bad), "facing-slanted");
  const auto made = [](const Aspect& aspect) { return aspect.summary.values.at(1).cause.front().code; };
  EXPECT_EQ(made(bad), "printed-by-nozzle");
  request_.print.printer = {.technique = PrintTechnique::Resin};
  EXPECT_EQ(made(printed(72, 0)), "printed-in-resin");
  request_.print.printer = {.technique = PrintTechnique::Powder};
  EXPECT_EQ(made(printed(72, 0)), "printed-in-powder");
  request_.print.printer = {};
  const Aspect down = printed(72, 170);  // the simulation does not show how it sags there
  EXPECT_EQ(facing(down), "facing-down");
  EXPECT_EQ(down.level, Level::Barely);
  EXPECT_EQ(down.reasons.at(1).code, "faces-down");
  EXPECT_EQ(printed(72, 130).level, Level::Good);
  EXPECT_TRUE(good.passed());
  EXPECT_TRUE(barely.passed());
  EXPECT_THAT(codesOf(bad.failed), ElementsAre("unreadable-as-printed"));
  EXPECT_EQ(neededIn(bad.failed.front()), 12);
  EXPECT_EQ(neededIn(judged(28).reads.failed.front()), 29) << "of the design";
  const PrintedEvidence unread{evidence(11), "fdm-0.4/0.2", 0};
  const Verdict verdict = judge(request_, carved(request_, 30, 0.5), evidence(72), &unread);
  EXPECT_FALSE(verdict.passed());
  EXPECT_EQ(verdict.failed().size(), 1u);
}

TEST_F(VerdictTest, OffersARemedyOnceIfBothChecksFail) {
  const PrintedEvidence unread{evidence(0), "fdm-0.4/0.2", 0};
  const auto judgedWith = [&](int reads) {
    return judge(request_, carved(request_, 30, 0.5), evidence(reads), &unread);
  };
  const Verdict both = judgedWith(0);
  ASSERT_FALSE(both.reads.passed() || both.prints.passed());
  EXPECT_THAT(settingsOf(both.reads.remedies), testing::Contains("preset=robust"));
  for (const Remedy& remedy : both.reads.remedies)
    EXPECT_THAT(both.prints.remedies, testing::Not(testing::Contains(remedy)));
  EXPECT_THAT(settingsOf(both.prints.remedies), ElementsAre("carveFor=print"));
  const Verdict printOnly = judgedWith(72);
  EXPECT_THAT(settingsOf(printOnly.prints.remedies), testing::Contains("preset=robust"));
}

TEST_F(VerdictTest, NamesAShellBelowThePocketsAsTheCause) {
  EngraveResult result = carved(request_, 30, 0.5);
  result.limitedSubmodules = 7;
  result.shellBelowMm = 1.5;
  EXPECT_THAT(codesOf(judge(request_, result, evidence(0)).reads.failed), ElementsAre("too-shallow-over-shell"));
  EXPECT_THAT(codesOf(judge(request_, result, evidence(72)).reads.reasons), testing::Contains("shell-below"))
      << "it barely reads";
}

TEST_F(VerdictTest, WarnsOfASearchThatEndedTooEarly) {
  EngraveResult result = carved(request_, 30, 0.5);
  result.limitedSubmodules = 7;
  result.unfinishedSubmodules = 4;
  result.searchIterations = 24;
  const Verdict verdict = judge(request_, result, evidence(0));
  EXPECT_THAT(codesOf(verdict.reads.warnings), ElementsAre("search-ended"));
  EXPECT_THAT(codesOf(verdict.reads.reasons), testing::Contains("submodules-limited"));
  result.limitedSubmodules = 4;
  EXPECT_THAT(codesOf(judge(request_, result, evidence(0)).reads.reasons),
              testing::Not(testing::Contains("submodules-limited")));
}

TEST_F(VerdictTest, WarnsOfALabelTooLowToPrintEvenIfTheCodePrints) {
  const PrintedEvidence good{evidence(72), "fdm-0.4/0.2", 0};
  const auto warnings = [&](const PrintedEvidence* printed) {
    return judge(request_, carved(request_, 30, 0.5), evidence(72), printed).prints.warnings;
  };
  EXPECT_TRUE(warnings(&good).empty());
  request_.code.label.text = "A-001";
  EXPECT_TRUE(warnings(&good).empty());
  request_.code.label.text = std::string(69, 'A');
  for (const Mark mark : {Mark::Shadow, Mark::Inlay, Mark::Paint}) {
    request_.marking.mark = mark;
    ASSERT_EQ(warnings(&good).size(), 1u);
    EXPECT_EQ(warnings(&good)[0].code, "label-too-small");
    EXPECT_EQ(warnings(nullptr).size(), 1u) << "the print was not simulated";
  }
}

TEST_F(VerdictTest, ReportsInheritedCrossingsAndFailsOnNewOnes) {
  EngraveResult result = carved(request_, 30, 0.5);
  result.solidity.selfIntersections = 35;
  result.inheritedSelfIntersections = 35;
  const Verdict inherited = judge(request_, result, evidence(72));
  EXPECT_EQ(inherited.solid.level, Level::Barely);
  EXPECT_THAT(inherited.solid.failed, IsEmpty());
  EXPECT_EQ(inherited.solid.reasons.front().code, "inherited-crossings");
  result.solidity.selfIntersections = result.inheritedSelfIntersections = kMaxCrossingsListed;
  EXPECT_EQ(judge(request_, result, evidence(72)).solid.reasons.front().code, "many-inherited-crossings");
  result.solidity.selfIntersections = 35;
  result.inheritedSelfIntersections = 34;
  EXPECT_EQ(judge(request_, result, evidence(72)).solid.level, Level::Bad);
}

class ColourVerdictTest : public VerdictTest {
 protected:
  ColourVerdictTest() {
    request_.marking.mark = Mark::Inlay;
    result_ = carved(request_, 30, 0);
    result_.markDepthMm = result_.opaqueDepthMm = 0.4;
    lay(request_.marking.ink());
  }
  /// Sets the luminance of whole modules in two colours.
  void lay(Ink ink) {
    request_.marking.darkReflectance = ink.dark;
    request_.marking.albedo = ink.light;
    for (int row = 0; row < 5 * result_.symbol.size; ++row)
      for (int column = 0; column < 5 * result_.symbol.size; ++column)
        result_.luminance.at(row + kQuietZoneSubmodules, column + kQuietZoneSubmodules) =
            result_.symbol.isDark(row / 5, column / 5) ? ink.dark / ink.light : 1;
  }
  Verdict judged(int reads) { return judge(request_, result_, evidence(reads)); }
  EngraveResult result_;
};

TEST_F(ColourVerdictTest, BlackOnWhiteIsGradedAndNeedsNoWarning) {
  const Verdict verdict = judged(72);
  EXPECT_EQ(verdict.reads.level, Level::Good);
  EXPECT_EQ(verdict.prints.level, Level::Good);
  EXPECT_THAT(verdict.reads.warnings, IsEmpty());
  EXPECT_EQ(gradesOf(request_, result_).iso15415, 4);
}

TEST_F(ColourVerdictTest, WarnsOfInvertedCodesAndOfColoursThatAreAlike) {
  lay({.dark = 0.85, .light = 0.05});
  EXPECT_THAT(codesOf(judged(72).reads.warnings), ElementsAre("code-inverted"));
  EXPECT_EQ(judged(72).reads.level, Level::Good);
  lay({.dark = 0.5, .light = 0.8});
  EXPECT_THAT(codesOf(judged(72).reads.warnings), ElementsAre("colours-alike"));
}

TEST_F(ColourVerdictTest, AnInvertedCodeThatDoesNotReadOffersToSwapTheColours) {
  lay({.dark = 0.85, .light = 0.05});
  EXPECT_EQ(judged(3).reads.failed.front().code, "inverted-ink-unreadable");
  EXPECT_EQ(settingsOf(judged(3).reads.remedies).front(), "albedo=0.85 darkReflectance=0.05");
  const PrintedEvidence unread{evidence(3), "fdm-0.4/0.2", 0};
  EXPECT_EQ(settingsOf(judge(request_, result_, evidence(72), &unread).prints.remedies).front(),
            "albedo=0.85 darkReflectance=0.05");
  lay({.dark = 1, .light = 0.05});
  EXPECT_EQ(settingsOf(judged(3).reads.remedies).front(), "albedo=0.95 darkReflectance=0.05") << "within the range";
  lay({.dark = 0.05, .light = 0.85});
  EXPECT_THAT(settingsOf(judged(3).reads.remedies),
              testing::Not(testing::Contains("albedo=0.05 darkReflectance=0.85")));
}

TEST_F(ColourVerdictTest, NeverBlamesTheDepthAndNeverAsksForMore) {
  const Verdict verdict = judged(3);
  EXPECT_EQ(verdict.reads.failed.front().code, "ink-unreadable");
  EXPECT_EQ(changeToTryNext(request_, verdict), std::nullopt);
  EXPECT_THAT(settingsOf(verdict.reads.remedies), testing::Not(testing::Contains("preset=robust")));
}

TEST_F(ColourVerdictTest, WarnsOfModulesNarrowerThanALineAndOffersAFinerNozzle) {
  result_.placement.moduleMm = 0.4;  // a line is 0.45 mm wide
  const Verdict verdict = judged(72);
  EXPECT_EQ(verdict.prints.level, Level::Barely);
  EXPECT_THAT(codesOf(verdict.prints.reasons), ElementsAre("modules-narrower-than-line"));
  EXPECT_THAT(settingsOf(verdict.prints.remedies), testing::Contains("nozzleMm=0.3"));
}

TEST_F(ColourVerdictTest, WarnsOfAProcessWithOneMaterial) {
  request_.print.printer.technique = PrintTechnique::Resin;
  EXPECT_THAT(codesOf(judged(72).prints.reasons), ElementsAre("one-material-process"));
}

TEST_F(ColourVerdictTest, AnInlayThatIsNoSolidFails) {
  result_.inlay = shapes::box({1, 1, 1});
  result_.inlaySolidity.triangles = 12;
  result_.inlaySolidity.openEdges = 3;
  const Aspect solid = judged(72).solid;
  EXPECT_EQ(solid.level, Level::Bad);
  EXPECT_EQ(solid.summary.code, "solid-not");
  EXPECT_EQ(solid.failed.front().code, "inlay-not-solid");
}

TEST_F(ColourVerdictTest, AThinInlayOffersPaint) {
  result_.markDepthMm = 0.25;
  const Verdict verdict = judged(72);
  EXPECT_THAT(codesOf(verdict.prints.reasons), ElementsAre("inlay-not-opaque"));
  EXPECT_THAT(settingsOf(verdict.prints.remedies), testing::Contains("mark=paint"));
  result_.modulesLeftOut = 2;
  EXPECT_THAT(codesOf(judged(72).reads.warnings), ElementsAre("modules-left-out"));
}

}  // namespace
}  // namespace qrelief
