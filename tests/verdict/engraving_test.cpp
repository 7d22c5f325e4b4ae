// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/engraving.h"

#include <gmock/gmock.h>

#include "io/write_stl.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using Step = Engraving::Step;

/// Plays the host: answers with numbers of successful tries.
class EngravingTest : public GlTest {
 protected:
  static std::shared_ptr<const EngravableModel> plate(double thickness = 20) {
    return EngravableModel::upload(*prepareModel(shapes::soupOf(shapes::box({60, 50, thickness})), {}));
  }
  static EngraveRequest requestAt(Vec3 centreMm, double sizeMm = 30) {
    EngraveRequest request = defaultRequest();
    request.code.text = "https://example.org/a";
    request.placement.centreMm = centreMm;
    request.placement.sizeMode = SizeMode::Fixed;
    request.placement.sizeMm = sizeMm;
    return request;
  }
  static ReadingEvidence read(int reads) { return {{72, reads}, reads > 0 ? "https://example.org/a" : ""}; }
  static PrintedEvidence print(int reads) { return {read(reads), "fdm-0.4/0.2", 0}; }

  /// Runs an engraving to its next question, or to its end.
  static Result<Step> toNext(Engraving& engraving) {
    for (;;) {
      const auto step = engraving.advance();
      if (!step || *step != Step::Work) return step;
    }
  }
};

TEST_F(EngravingTest, AsksForTheTextsThenForThePrintAndDelivers) {
  Engraver engraver(plate());
  Engraving engraving(engraver, requestAt({0, 0, 10}), {});
  ASSERT_EQ(*toNext(engraving), Step::Decode);
  EXPECT_FALSE(engraving.isWorking());
  EXPECT_FALSE(engraving.pictures().empty());
  EXPECT_EQ(engraving.best(), nullptr) << "it is not known yet whether it reads";
  engraving.decoded(read(72), 5);
  ASSERT_EQ(*engraving.advance(), Step::Print);
  ASSERT_NE(engraving.best(), nullptr) << "it may be delivered before its print";
  engraving.printed(print(60), 7);
  ASSERT_EQ(*engraving.advance(), Step::Done);
  const Engraved& best = *engraving.best();
  EXPECT_TRUE(best.verdict.passed());
  EXPECT_EQ(best.attempt, 0);
  EXPECT_EQ(best.tried.size(), 1u);
  EXPECT_EQ(best.printed->reading.count.reads, 60);
  EXPECT_EQ(best.result.timingsMs.print, 7);
  EXPECT_GT(best.workMs, 0);
}

TEST_F(EngravingTest, OffersTheFileForItsPrintBeforeItIsChecked) {
  Engraver engraver(plate());
  Engraving engraving(engraver, requestAt({0, 0, 10}), {});
  bool wasPrintable = false;
  while (*engraving.advance() == Step::Work) {
    const EngraveResult* const written = engraving.printable();
    if (!written) continue;
    wasPrintable = true;
    EXPECT_FALSE(written->mesh.triangles.empty());
  }
  EXPECT_TRUE(wasPrintable);
  EXPECT_EQ(engraving.printable(), nullptr) << "it is finished";
}

TEST_F(EngravingTest, CarvesDeeperWhileNothingDecodesAndReturnsToTheFirst) {
  Engraver engraver(plate());
  Engraving engraving(engraver, requestAt({0, 0, 10}), {.fixed = {"text", "ecc", "mark"}});
  ASSERT_EQ(*toNext(engraving), Step::Decode);
  engraving.decoded(read(0));
  const auto first = engraving.best();
  int others = 0;
  auto step = toNext(engraving);
  for (; *step == Step::Decode; step = toNext(engraving), ++others) {
    EXPECT_NE(engraving.current(), first);
    EXPECT_EQ(engraving.best(), first);
    engraving.decoded(read(0));
  }
  EXPECT_GE(others, 2);
  ASSERT_EQ(*step, Step::Print);
  EXPECT_EQ(engraving.current(), first);
  engraving.printed(print(0));
  step = toNext(engraving);
  ASSERT_EQ(*step, Step::Done);
  EXPECT_EQ(engraving.best(), first);
  EXPECT_EQ(first->tried.size(), static_cast<std::size_t>(others) + 1) << "it names all attempts";
}

TEST_F(EngravingTest, ProgressNeverGoesBackFromOneAttemptToTheNext) {
  Engraver engraver(plate());
  Engraving engraving(engraver, requestAt({0, 0, 0}), {.mayMove = true});
  double last = 0;
  int attempts = 0;
  for (auto step = Step::Work; step != Step::Done; step = *engraving.advance()) {
    const Progress progress = engraving.progress();
    EXPECT_GE(progress.fraction, last) << progress.stage << " of attempt " << engraving.plan().attempt();
    EXPECT_LT(progress.fraction, 1) << progress.stage;
    last = progress.fraction;
    if (step == Step::Decode) {
      ++attempts;
      engraving.decoded(read(72));
    } else if (step == Step::Print) {
      engraving.printed(print(20));  // barely: it is carved deeper
    }
  }
  EXPECT_GE(attempts, 2);
  EXPECT_EQ(engraving.progress().fraction, 1);
}

TEST_F(EngravingTest, ReturnsTheErrorOfTheCodeAsRequestedWithTheOfferThatWouldDo) {
  Engraver engraver(plate(0.8));  // too thin for pockets
  Engraving engraving(engraver, requestAt({0, 0, 0.4}), {.looksAtPrint = false, .offersMarks = true});
  Result<Step> step = toNext(engraving);
  for (; step && *step == Step::Decode; step = toNext(engraving)) engraving.decoded(read(72));
  ASSERT_FALSE(step.has_value());
  EXPECT_EQ(step.error().kind, ErrorKind::NoSolution);
  EXPECT_TRUE(passedOffer(engraving.plan().tried()));
  EXPECT_EQ(engraving.best(), nullptr);
}

TEST_F(EngravingTest, FindsItsOwnSpotIfItMayMove) {
  Engraver engraver(plate());
  EngraveRequest request = requestAt({0, 0, 0});
  Engraving engraving(engraver, request, {.looksAtPrint = false, .mayMove = true});
  ASSERT_EQ(*toNext(engraving), Step::Decode);
  EXPECT_NE(engraving.request().placement.centreMm, request.placement.centreMm);
  engraving.decoded(read(72));
  ASSERT_EQ(*engraving.advance(), Step::Done);
  EXPECT_GT(engraving.best()->spotMs, 0);
}

TEST_F(EngravingTest, ATextHasNothingToDecode) {
  Engraver engraver(plate());
  EngraveRequest request = requestAt({0, 0, 10});
  request.code.content = Content::Text;
  request.code.text = "Rev B";
  Engraving engraving(engraver, request, {});
  ASSERT_EQ(*toNext(engraving), Step::Done);
  EXPECT_TRUE(engraving.best()->verdict.passed());
}

TEST_F(EngravingTest, EngravingsOfOneModelShareThePlaceAndWorkDoneAhead) {
  Engraver engraver(plate());
  const EngraveRequest request = requestAt({0, 0, 10});
  EXPECT_TRUE(engraver.prepare(request, false)) << "its place is not known";
  const auto carve = [&] {
    Engraving engraving(engraver, request, {});
    int steps = 0;
    do ++steps;
    while (*engraving.advance() == Step::Work);
    return std::pair(steps, writeStl(engraving.current()->result.mesh));
  };
  const auto [firstSteps, first] = carve();
  const auto [secondSteps, second] = carve();
  EXPECT_LT(secondSteps, firstSteps) << "the place is known";
  EXPECT_EQ(second, first);
  while (!engraver.prepare(request, false)) {
  }
  const auto [thirdSteps, third] = carve();
  EXPECT_LT(thirdSteps, secondSteps);
  EXPECT_EQ(third, first);
  while (!engraver.prepare(request, true)) {
  }
  ASSERT_NE(engraver.prepared(request), nullptr);
  EXPECT_TRUE(engraver.prepared(request)->hasSearched());
  const auto [fourthSteps, fourth] = carve();
  EXPECT_LE(fourthSteps, thirdSteps) << "a few steps may be the whole search";
  EXPECT_EQ(fourth, first);
}

}  // namespace
}  // namespace qrelief
