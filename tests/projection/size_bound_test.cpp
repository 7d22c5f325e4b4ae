// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/size_bound.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "message_codes/pipeline.h"
#include "messages/sentences.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

PreparedModel prepared(const Mesh& mesh) {
  auto model = prepareModel(shapes::soupOf(mesh), {});
  EXPECT_TRUE(model) << model.error().message;
  return std::move(*model);
}

constexpr SizeBound kSmallest{21, 29.0 / 21};  // 5.8 mm with the quiet zone
constexpr double kEyeMm = 250;

TEST(Room, OfAFlatSquareIsItsEdgeForADistantEye) {
  EXPECT_NEAR(squareBoundMm({{0, 0, 0}, {30, 30, 0}}, 1e9), 30, 1e-5);
}

TEST(Room, GrowsAsTheEyeComesNear) {
  // A diagonal of 50 mm is seen from 250 mm. Points that far in front of the plane are enlarged by 250 / 200.
  EXPECT_NEAR(squareBoundMm({{0, 0, 0}, {30, 40, 0}}, kEyeMm), 50 * 1.25 / std::numbers::sqrt2, 1e-9);
  EXPECT_EQ(squareBoundMm({{0, 0, 0}, {200, 200, 0}}, kEyeMm), std::numeric_limits<double>::infinity());
}

TEST(Room, RefusesAModelOfAFifthOfAMillimetreAndSuggestsTheUnit) {
  const Status refused = checkSizeBound(prepared(shapes::box({0.2, 0.2, 0.2})), kSmallest, kEyeMm);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::NoSolution);
  EXPECT_EQ(refused.error().message.code, "model-too-small");
  EXPECT_EQ(
      sentence(refused.error().message),
      "The model is too small for any code: it is 0.2 × 0.2 × 0.2 mm, so at most a code of 0.178 mm fits; 21 × 21 "
      "modules need 4.2 mm with modules of 0.2 mm, the smallest that print and decode");
  EXPECT_THAT(hint(refused.error().message), testing::HasSubstr("--units m makes it 200 × 200 × 200 mm"));
}

TEST(Room, AcceptsAModelThatJustFitsTheSmallestCode) {
  EXPECT_TRUE(checkSizeBound(prepared(shapes::box({5.8, 5.8, 1})), kSmallest, kEyeMm));
  EXPECT_FALSE(checkSizeBound(prepared(shapes::box({5, 5, 0.1})), kSmallest, kEyeMm));
}

TEST(Room, ForALongTextAsksForALargerModelOrAShorterText) {
  const SizeBound largest{177, 185.0 / 177};
  const Status refused = checkSizeBound(prepared(shapes::box({30, 20, 10})), largest, kEyeMm);
  ASSERT_FALSE(refused);
  EXPECT_EQ(hint(refused.error().message), "Make the model larger (--scale), or shorten the text");
  const Status small = checkSizeBound(prepared(shapes::box({20, 20, 20})), largest, kEyeMm);
  ASSERT_FALSE(small);
  EXPECT_EQ(
      hint(small.error().message),
      "Shorten the text. If it should be larger, --units cm makes it 200 × 200 × 200 mm; use --scale for any other "
      "scale");
  EXPECT_TRUE(checkSizeBound(prepared(shapes::box({40, 40, 40})), largest, kEyeMm));
}

TEST(Room, SuggestsOnlyUnitsInWhichTheCodeHasRoom) {
  const PreparedModel model = prepared(shapes::box({12, 3, 2}));
  const Message otherwise = message<"larger-or-flatter">();
  const Message advice = roomAdvice(model, kSmallest, kEyeMm, otherwise);
  EXPECT_THAT(sentence(advice),
              testing::HasSubstr("--units in makes it 305 × 76.2 × 50.8 mm, --units cm 120 × 30 × 20"));
  const SizeBound wide{177, 20};
  EXPECT_EQ(roomAdvice(model, wide, 1e9, otherwise), otherwise);
  EXPECT_EQ(roomAdvice(prepared(shapes::box({31, 3, 2})), kSmallest, kEyeMm, otherwise), otherwise);
}

}  // namespace
}  // namespace qrelief
