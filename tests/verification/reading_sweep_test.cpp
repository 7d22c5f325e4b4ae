// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/reading_sweep.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "mesh/ray_tree.h"
#include "support/shapes.h"
#include "verification/view_trials.h"

namespace qrelief {
namespace {

constexpr int kModules = 21;
constexpr double kSymbolMm = 21;

/// Fixture with a sweep over a plain plate; the given decoders determine the result.
class ReadingSweepTest : public testing::Test {
 protected:
  ReadingSweepTest() {
    while (!light_.bakeRows(50)) {
    }
  }

  ReadingSweep sweep(std::vector<Decoder> decoders, const SweepOptions& options = {}) {
    ReadingSweep sweep(light_, frame_, kModules, kSymbolMm, "WANTED", std::move(decoders), options);
    while (!sweep.step()) {
    }
    return sweep;
  }

  /// Returns the wanted text at its position in every picture.
  static SymbolRead wanted(const GreyImage& picture) {
    const double modules = kModules + 2 * kPictureMarginModules, module = picture.width / modules;
    const double begin = kPictureMarginModules * module, end = (kPictureMarginModules + kModules) * module;
    return {"WANTED", false, {Vec2(begin, begin), Vec2(end, begin), Vec2(end, end), Vec2(begin, end)}};
  }

  Mesh plate_ = shapes::box({60, 60, 4});
  RayTree tree_{plate_};
  ProjectionFrame frame_ = makeFrame({0, 0, 2}, {0, 0, 1}, {0, 1, 0}, 250);
  BakedLight light_{tree_,
                    frame_,
                    {.texelMm = kSymbolMm / kModules / kBakedPixels,
                     .texels = kBakedPixels * (kModules + 2 * kPictureMarginModules),
                     .paths = 1}};
};

TEST_F(ReadingSweepTest, ADecoderThatAlwaysDecodesPassesEverywhere) {
  const ReadingSweep done = sweep({wanted});
  const ReadingSummary summary = done.summary();
  EXPECT_EQ(summary.frontal, (ReadingCount{36, 36}));
  EXPECT_TRUE(summary.frontal.enough());
  EXPECT_EQ(summary.tiltDeg, 45);
  EXPECT_EQ(summary.tiltDegLamp, 45);
  EXPECT_EQ(summary.pixelsPerModule, 2.0);
  EXPECT_EQ(summary.blurModules, 0.5);
  ASSERT_TRUE(summary.cornerErrorModules);
  EXPECT_LT(*summary.cornerErrorModules, 0.1);
  for (const ReadingView& view : done.views()) EXPECT_TRUE(view.read());
}

TEST_F(ReadingSweepTest, ADecoderThatNeverDecodesPassesNowhere) {
  const ReadingSummary summary = sweep({[](const GreyImage&) { return std::nullopt; }}).summary();
  EXPECT_EQ(summary.frontal, (ReadingCount{36, 0}));
  EXPECT_FALSE(summary.frontal.enough());
  EXPECT_EQ(summary.tiltDeg, std::nullopt);
  EXPECT_EQ(summary.pixelsPerModule, std::nullopt);
  EXPECT_EQ(summary.cornerErrorModules, std::nullopt);
}

TEST_F(ReadingSweepTest, CountsAllTriesOfAllDecoders) {
  const ReadingSummary summary =
      sweep({wanted, [](const GreyImage&) { return std::nullopt; }}, {.ranges = false}).summary();
  EXPECT_EQ(summary.frontal, (ReadingCount{72, 36}));
  EXPECT_TRUE(summary.frontal.enough());
  EXPECT_EQ(summary.tiltDeg, std::nullopt);  // was not requested
}

TEST_F(ReadingSweepTest, TheDistanceEndsAtTheFirstPictureThatIsTooSmall) {
  const double across = kModules + 2 * kPictureMarginModules;
  const auto atLeastThreePixels = [&](const GreyImage& picture) -> std::optional<SymbolRead> {
    if (picture.width < 3 * across) return std::nullopt;
    return wanted(picture);
  };
  const ReadingSummary summary = sweep({atLeastThreePixels}).summary();
  EXPECT_EQ(summary.pixelsPerModule, 3.3);
}

TEST_F(ReadingSweepTest, DoesNotCountMirroredOrOtherTexts) {
  const auto mirrored = [](const GreyImage& picture) {
    SymbolRead read = wanted(picture);
    read.mirrored = true;
    return std::optional(read);
  };
  const ReadingSummary first = sweep({mirrored}, {.ranges = false}).summary();
  EXPECT_EQ(first.frontal.reads, 0);
  EXPECT_TRUE(first.mirrored);
  const auto other = [](const GreyImage& picture) {
    SymbolRead read = wanted(picture);
    read.text = "OTHER";
    return std::optional(read);
  };
  const ReadingSummary second = sweep({other}, {.ranges = false}).summary();
  EXPECT_EQ(second.frontal.reads, 0);
  EXPECT_EQ(second.otherText, "OTHER");
}

TEST_F(ReadingSweepTest, MeasuresTheOffsetOfASymbolInModules) {
  const auto shifted = [](const GreyImage& picture) {
    SymbolRead read = wanted(picture);
    for (Vec2& corner : read.corners) corner.x += 3.0 * picture.width / (kModules + 2 * kPictureMarginModules);
    return std::optional(read);
  };
  EXPECT_NEAR(sweep({shifted}, {.ranges = false}).summary().cornerErrorModules.value_or(0), 3, 0.1);
}

TEST_F(ReadingSweepTest, EveryPictureIsLitByTheLamp) {
  const ReadingSweep done = sweep({wanted}, {.underLamps = true});
  for (const ReadingView& view : done.views()) EXPECT_TRUE(view.lamp);
  EXPECT_EQ(done.summary().tiltDegLamp, 45);
  EXPECT_EQ(done.summary().tiltDeg, std::nullopt);
  EXPECT_EQ(done.views().size(), sweep({wanted}).views().size() - kTiltsDeg.size() * kAzimuthsDeg.size());
}

TEST_F(ReadingSweepTest, PicturesDifferInScalePhaseAndBlur) {
  const ReadingSweep done = sweep({wanted}, {.ranges = false});
  EXPECT_EQ(done.views().size(), kFrontalViews.size());
  EXPECT_TRUE(std::all_of(done.views().begin(), done.views().end(),
                          [](const ReadingView& view) { return view.test == ReadingTest::Frontal; }));
}

}  // namespace
}  // namespace qrelief
