// SPDX-License-Identifier: GPL-3.0-or-later
#include "label/label_layout.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "message_codes/text.h"
#include "qr/symbol.h"

namespace qrelief {
namespace {

constexpr int kModules = 25;
constexpr double kQuietEdge = kModules / 2.0 + kQuietZoneModules;

LabelLayout layout(const LabelOptions& label) {
  const auto laidOut = layOutLabel(label, kModules);
  EXPECT_TRUE(laidOut.has_value()) << laidOut.error().message;
  return laidOut.value_or(LabelLayout{});
}

Rectangle boundsOf(const LabelLayout& layout) {
  Rectangle box{Vec2(INFINITY), Vec2(-INFINITY)};
  for (const Ring& ring : layout.rings)
    for (const Vec2 corner : ring) box = {glm::min(box.low, corner), glm::max(box.high, corner)};
  return box;
}

/// Expects that every corner lies outside the quiet zone, within the margin, and in a covered rectangle.
void expectInItsRoom(const LabelOptions& label, const LabelLayout& layout) {
  const double edge = kModules / 2.0 + labelMarginModules(label, kModules);
  for (const Ring& ring : layout.rings)
    for (const Vec2 corner : ring) {
      EXPECT_GE(std::max(std::abs(corner.x), std::abs(corner.y)), kQuietEdge - 1e-9);
      EXPECT_LE(std::max(std::abs(corner.x), std::abs(corner.y)), edge);
      EXPECT_TRUE(std::any_of(layout.covered.begin(), layout.covered.end(), [&](const Rectangle& box) {
        return corner.x >= box.low.x - 1e-9 && corner.y >= box.low.y - 1e-9 && corner.x <= box.high.x + 1e-9 &&
               corner.y <= box.high.y + 1e-9;
      }));
    }
}

TEST(LabelLayout, ShortTextIsAnEighthOfTheSymbolHighAndCentred) {
  const LabelOptions label{"No 7", LabelFrame::None};
  const LabelLayout laidOut = layout(label);
  EXPECT_DOUBLE_EQ(laidOut.capitalModules, kModules / 8.0);
  const Rectangle box = boundsOf(laidOut);
  EXPECT_NEAR(box.low.x, -box.high.x, 1e-9);
  EXPECT_LT(box.high.y, -kQuietEdge);
  expectInItsRoom(label, laidOut);
}

TEST(LabelLayout, LongTextIsAsWideAsTheSymbol) {
  const LabelOptions label{"https://example.org/p/0123456789", LabelFrame::None};
  const LabelLayout laidOut = layout(label);
  const Rectangle box = boundsOf(laidOut);
  EXPECT_NEAR(box.high.x - box.low.x, kModules, 1e-9);
  EXPECT_LT(laidOut.capitalModules, kModules / 8.0);
  expectInItsRoom(label, laidOut);
}

TEST(LabelLayout, AFrameEnclosesQuietZoneAndText) {
  for (const LabelFrame frame : {LabelFrame::Rounded, LabelFrame::Square}) {
    const LabelOptions plain{"", frame}, both{"g", frame};
    const LabelLayout alone = layout(plain), around = layout(both);
    EXPECT_EQ(alone.rings.size(), 2u);
    EXPECT_EQ(alone.capitalModules, 0);
    EXPECT_NEAR(boundsOf(alone).low.y, -kQuietEdge - 1.5, 1e-9);
    EXPECT_LT(boundsOf(around).low.y, boundsOf(alone).low.y);
    EXPECT_NEAR(boundsOf(around).high.y, kQuietEdge + 1.5, 1e-9);
    expectInItsRoom(plain, alone);
    expectInItsRoom(both, around);
  }
}

TEST(LabelLayout, ARoundedFrameHasOneModuleOfLineAlsoInItsCorners) {
  const LabelLayout laidOut = layout({"", LabelFrame::Rounded});
  ASSERT_EQ(laidOut.rings.size(), 2u);
  double area = 0;
  for (const Ring& ring : laidOut.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) area += cross2(ring[i], ring[(i + 1) % ring.size()]) / 2;
  // Straight parts of a module's width, and a ring with radii 1.5 and 2.5 modules for the four corners.
  const double straight = 4 * (2 * (kQuietEdge + 0.5) - 3), corners = std::numbers::pi * (2.5 * 2.5 - 1.5 * 1.5);
  EXPECT_NEAR(area, straight + corners, 0.1);
}

TEST(LabelLayout, TheMarginIsTheSameForAllTexts) {
  EXPECT_EQ(labelMarginModules({"1", LabelFrame::None}, kModules),
            labelMarginModules({"Ägypten, 100 Stück", LabelFrame::None}, kModules));
  EXPECT_EQ(labelMarginModules({}, kModules), 0);
  expectInItsRoom({"Äg", LabelFrame::None}, layout({"Äg", LabelFrame::None}));
}

TEST(LabelLayout, TextOfSpacesIsRefused) {
  const auto laidOut = layOutLabel({"  ", LabelFrame::None}, kModules);
  ASSERT_FALSE(laidOut.has_value());
  EXPECT_EQ(laidOut.error().message, message<"label-empty">());
}

TEST(LabelLayout, ALabelHasOneLine) {
  const auto laidOut = layOutLabel({"No. 1\nRev B", LabelFrame::None}, kModules);
  ASSERT_FALSE(laidOut.has_value());
  EXPECT_EQ(laidOut.error().message.code, "label-has-lines");
}

TEST(LabelLayout, ATextAloneFillsTheSquareInOneDirection) {
  const auto sizeOf = [](const std::string& text, LabelFrame frame = LabelFrame::None) {
    const Rectangle box = boundsOf(layout({text, frame, true}));
    EXPECT_NEAR(glm::length(box.low + box.high), 0, 1e-9) << text;
    return box.high - box.low;
  };
  EXPECT_NEAR(sizeOf("Rev B").x, kModules, 1e-9);
  EXPECT_NEAR(sizeOf("1\n2\n3\n4").y, kModules, 1e-9);
  EXPECT_NEAR(sizeOf("Rev B", LabelFrame::Rounded).x, kModules, 1e-9);
  EXPECT_NEAR(sizeOf("Rev B", LabelFrame::Square).x, kModules, 1e-9);
  EXPECT_EQ(labelMarginModules({"Rev B", LabelFrame::None, true}, kModules), 0);
}

TEST(LabelLayout, LinesOfATextAloneAreCentredAndClearOfEachOther) {
  // Marks below and above the letters come near each other.
  const LabelLayout laidOut = layout({"gjpqy\r\n\u1EA4\u00C5", LabelFrame::None, true});
  double lowestAbove = INFINITY, highestBelow = -INFINITY;
  for (const Ring& ring : laidOut.rings) {
    Rectangle box{Vec2(INFINITY), Vec2(-INFINITY)};
    for (const Vec2 corner : ring) box = {glm::min(box.low, corner), glm::max(box.high, corner)};
    if ((box.low.y + box.high.y) / 2 > 0)
      lowestAbove = std::min(lowestAbove, box.low.y);
    else
      highestBelow = std::max(highestBelow, box.high.y);
  }
  EXPECT_GT(lowestAbove - highestBelow, 0.1 * laidOut.capitalModules);
  const LabelLayout pair = layout({"HH\nH", LabelFrame::None, true});
  ASSERT_EQ(pair.rings.size(), 3u);
  const auto [left, right] = std::minmax_element(pair.rings.back().begin(), pair.rings.back().end(),
                                                 [](const Vec2 a, const Vec2 b) { return a.x < b.x; });
  EXPECT_NEAR(left->x, -right->x, 1e-9);
}

TEST(LabelLayout, AFrameRoundATextAloneEnclosesIt) {
  const LabelLayout framed = layout({"Rev B", LabelFrame::Square, true});
  const Ring& inner = framed.rings[1];
  for (std::size_t r = 2; r < framed.rings.size(); ++r)
    for (const Vec2 corner : framed.rings[r]) {
      EXPECT_LT(std::abs(corner.x), std::abs(inner.front().x));
      EXPECT_LT(std::abs(corner.y), std::abs(inner.front().y));
    }
}

TEST(LabelLayout, ATextAloneOfSpacesIsRefused) {
  const auto laidOut = layOutLabel({" \n", LabelFrame::None, true}, kModules);
  ASSERT_FALSE(laidOut.has_value());
  EXPECT_EQ(laidOut.error().message, message<"text-alone-empty">());
}

TEST(LabelLayout, TheLeastHeightHasStrokesOfOneLine) {
  EXPECT_NEAR(leastCapitalMm(0.45) * thinnestStroke(), 0.45, 1e-12);
  const LabelLayout laidOut = layout({"No 7", LabelFrame::None});
  EXPECT_NEAR(laidOut.thinnestStrokeModules / laidOut.capitalModules, thinnestStroke(), 1e-12);
}

}  // namespace
}  // namespace qrelief
