// SPDX-License-Identifier: GPL-3.0-or-later
#include "label/text_outline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "message_codes/text.h"
#include "projection/plane_shapes.h"

namespace qrelief {
namespace {

constexpr double kTolerance = 0.002;

double signedArea(const Ring& ring) {
  double area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) area += cross2(ring[i], ring[(i + 1) % ring.size()]) / 2;
  return area;
}

double area(const TextOutline& text) {
  double sum = 0;
  for (const Ring& ring : text.rings) sum += signedArea(ring);
  return sum;
}

TextOutline outline(std::string_view text, double tolerance = kTolerance) {
  const auto outline = outlineText(text, tolerance);
  EXPECT_TRUE(outline.has_value()) << outline.error().message;
  return outline.value_or(TextOutline{});
}

std::vector<Segment2> sidesOf(const TextOutline& text) {
  std::vector<Segment2> sides;
  for (const Ring& ring : text.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) sides.push_back({ring[i], ring[(i + 1) % ring.size()]});
  return sides;
}

/// Returns true if two sides touch that are not neighbours in one ring.
bool crossesItself(const TextOutline& text) {
  const std::vector<Segment2> sides = sidesOf(text);
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      const auto& [a, b] = sides[i];
      const auto& [c, d] = sides[j];
      if (a == d || b == c) continue;
      if (glm::max(a, b).x < glm::min(c, d).x || glm::max(c, d).x < glm::min(a, b).x) continue;
      if (distanceBetween(sides[i], sides[j]) < 1e-9) return true;
    }
  return false;
}

TEST(TextOutline, ACapitalIsOneUnitHigh) {
  const TextOutline h = outline("H");
  EXPECT_DOUBLE_EQ(h.low.y, 0);
  EXPECT_DOUBLE_EQ(h.high.y, 1);
  ASSERT_EQ(h.rings.size(), 1u);
  EXPECT_EQ(h.rings[0].size(), 12u);
  EXPECT_GT(signedArea(h.rings[0]), 0);
}

TEST(TextOutline, HolesRunClockwiseAndAreSubtracted) {
  const TextOutline eight = outline("8");
  ASSERT_EQ(eight.rings.size(), 3u);
  int outer = 0;
  for (const Ring& ring : eight.rings) outer += signedArea(ring) > 0 ? 1 : 0;
  EXPECT_EQ(outer, 1);
  EXPECT_LT(area(eight), area(outline("0")) + area(outline("1")));
}

TEST(TextOutline, ChordsStayWithinTheTolerance) {
  const TextOutline fine = outline("O", 1e-5), coarse = outline("O", 0.01);
  const std::vector<Segment2> chords = sidesOf(coarse);
  double farthest = 0;
  for (const Ring& ring : fine.rings)
    for (const Vec2 point : ring) {
      double nearest = INFINITY;
      for (const Segment2& chord : chords) nearest = std::min(nearest, distanceToSegment(point, chord));
      farthest = std::max(farthest, nearest);
    }
  EXPECT_LE(farthest, 0.01 + 1e-5);
  EXPECT_LT(sidesOf(coarse).size(), sidesOf(fine).size() / 8);
}

TEST(TextOutline, PairsAreKerned) {
  // A and V lean into each other; two Hs do not.
  const auto width = [](const TextOutline& text) { return text.high.x - text.low.x; };
  EXPECT_LT(width(outline("AV")), width(outline("A")) + width(outline("V")));
  EXPECT_GT(width(outline("HH")), 2 * width(outline("H")));
  // In Cyrillic, too, whose pairs come last in the font. Both alphabets have this T and A, and the font kerns them
  // alike.
  EXPECT_DOUBLE_EQ(width(outline("\u0422\u0410")), width(outline("TA")));
}

TEST(TextOutline, SpacesTakeRoom) {
  EXPECT_GT(outline("a b").high.x, outline("ab").high.x + 0.2);
  EXPECT_TRUE(outline(" ").rings.empty());
}

TEST(TextOutline, NamesTheCharactersThatTheFontLacks) {
  const auto text = outlineText("Nr. 漢 7 字漢", kTolerance);
  ASSERT_FALSE(text.has_value());
  EXPECT_EQ(text.error().kind, ErrorKind::BadInput);
  EXPECT_EQ(text.error().message, message<"label-lacks-characters">(with::quoted<"characters">("漢 字")));
  EXPECT_EQ(outlineText("a\tb\n\u200D", kTolerance).error().message,
            message<"label-lacks-characters">(with::quoted<"characters">("U+0009 U+000A U+200D")))
      << "characters that cannot be seen are named";
}

TEST(TextOutline, RefusesTextThatIsNotUtf8) {
  const auto text = outlineText("a\xff", kTolerance);
  ASSERT_FALSE(text.has_value());
  EXPECT_EQ(text.error().message, message<"text-no-utf8">(with::index<"byte">(1)));
}

TEST(TextOutline, ReadsAccentsGreekAndCyrillic) {
  EXPECT_EQ(outline("Äöß").rings.size(), 9u);  // A, its hole and two dots; o, its hole and two dots; ß
  EXPECT_FALSE(outline("Ωж").rings.empty());
}

TEST(TextOutline, ComposesLettersAndTheirMarks) {
  for (const auto& [apart, one] : {std::pair("Mu\xCC\x88ller", "M\xC3\xBCller"), std::pair("e\xCC\x81", "\xC3\xA9"),
                                   std::pair("\xD0\xB8\xCC\x86", "\xD0\xB9")}) {
    const auto outline = outlineText(apart, 0.01), expected = outlineText(one, 0.01);
    ASSERT_TRUE(outline) << outline.error().message;
    EXPECT_EQ(outline->rings, expected->rings) << one;
  }
}

TEST(TextOutline, NoOutlineOfPrintableAsciiCrossesItsNeighbours) {
  for (char left = '!'; left <= '~'; ++left) {
    std::string text;
    for (char right = '!'; right <= '~'; ++right) {
      text = {left, right};
      EXPECT_FALSE(crossesItself(outline(text, 0.02))) << text;
    }
  }
}

TEST(TextOutline, NoLetterOfLatin1CrossesItself) {
  for (char32_t c = 0xC0; c <= 0xFF; ++c) {
    const std::string text = {static_cast<char>(0xC0 | (c >> 6)), static_cast<char>(0x80 | (c & 0x3F))};
    EXPECT_FALSE(crossesItself(outline(text, 0.02))) << text;
  }
}

TEST(TextOutline, TheThinnestStrokeIsTheBarOfAnH) {
  EXPECT_GT(thinnestStroke(), 0.1);
  EXPECT_LT(thinnestStroke(), 0.25);
}

}  // namespace
}  // namespace qrelief
