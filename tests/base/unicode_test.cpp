// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/unicode.h"

#include <gtest/gtest.h>
#include <vector>

namespace qrelief {
namespace {

TEST(Unicode, LettersAndTheirMarksAreComposed) {
  EXPECT_EQ(composed("u\u0308ber"), "\u00FCber");
  EXPECT_EQ(composed("A\u030A"), "\u00C5");
  EXPECT_EQ(composed("\u212B"), "\u00C5");              // the sign for ångström is the letter
  EXPECT_EQ(composed("\u03B1\u0301"), "\u03AC");        // Greek
  EXPECT_EQ(composed("\u0438\u0306"), "\u0439");        // Cyrillic
  EXPECT_EQ(composed("\u304B\u3099"), "\u304C");        // Japanese
  EXPECT_EQ(composed("\u1112\u1161\u11AB"), "\uD55C");  // Korean
  EXPECT_EQ(composed("\uD558\u11AB"), "\uD55C");
  EXPECT_EQ(composed("a\u0302\u0301"), "\u1EA5");  // Vietnamese: two marks in one letter
}

TEST(Unicode, MarksAreOrderedBeforeTheyAreComposed) {
  EXPECT_EQ(composed("s\u0307\u0323"), "\u1E69");
  EXPECT_EQ(composed("s\u0323\u0307"), "\u1E69");
  EXPECT_EQ(composed("q\u0307\u0323"), "q\u0323\u0307");  // no letter holds them
  EXPECT_EQ(composed("a\u0315\u0300"), "\u00E0\u0315");
  EXPECT_EQ(composed("a\u0300\u0300"), "\u00E0\u0300");
}

TEST(Unicode, CharactersThatNeverComposeStayApart) {
  EXPECT_EQ(composed("\u0958"), "\u0915\u093C");        // Devanagari qa, which is excluded from composition
  EXPECT_EQ(composed("\uFB2C"), "\u05E9\u05BC\u05C1");  // Hebrew shin with two points
}

TEST(Unicode, ComposedAsciiAndBrokenBytesStay) {
  EXPECT_EQ(composed("plate-01.stl"), "plate-01.stl");
  EXPECT_EQ(composed(""), "");
  EXPECT_EQ(composed("u\u0308\xFF\xC3"), "\u00FC\xFF\xC3");
}

TEST(Unicode, CaseDoesNotCountInAnyScript) {
  EXPECT_EQ(caseFolded("PLATE.STL"), "plate.stl");
  EXPECT_EQ(caseFolded("\u00C9"), caseFolded("e\u0301"));
  EXPECT_EQ(caseFolded("\u041F\u041B\u0410\u0422\u0410"), "\u043F\u043B\u0430\u0442\u0430");
  EXPECT_EQ(caseFolded("\u03A3\u03A4\u039F\u03A3"), caseFolded("\u03C3\u03C4\u03BF\u03C2"));  // final sigma
  EXPECT_EQ(caseFolded("STRASSE"), caseFolded("stra\u00DFe"));
  EXPECT_EQ(caseFolded("STRA\u1E9EE"), caseFolded("stra\u00DFe"));
  EXPECT_EQ(caseFolded("\uFB01le"), "file");          // a ligature
  EXPECT_EQ(caseFolded("\U00010400"), "\U00010428");  // Deseret, beyond the first plane
  EXPECT_EQ(caseFolded("\u0130"), caseFolded("i\u0307"));
}

TEST(Unicode, LettersThatOnlyLookAlikeStayDifferent) {
  EXPECT_NE(caseFolded("a"), caseFolded("\u0430"));  // Latin and Cyrillic
  EXPECT_NE(caseFolded("\u0131"), caseFolded("i"));  // dotless i
  EXPECT_NE(caseFolded("e"), caseFolded("\u00E9"));
}

TEST(Unicode, ReadsUtf16OfBothByteOrders) {
  const std::vector<std::uint8_t> little = {0xFF, 0xFE, 0xFC, 0x00, 0x3D, 0xD8, 0x00, 0xDE},
                                  big = {0xFE, 0xFF, 0x00, 0xFC, 0xD8, 0x3D, 0xDE, 0x00};
  EXPECT_EQ(utf8FromUtf16(little, false), "\u00FC\U0001F600");
  EXPECT_EQ(utf8FromUtf16(big, true), "\u00FC\U0001F600");
  EXPECT_FALSE(utf8FromUtf16(std::span(little).first(7), false));
  EXPECT_FALSE(utf8FromUtf16(std::span(little).first(6), false)) << "half a pair";
  EXPECT_FALSE(utf8FromUtf16(std::span(little).subspan(6), false)) << "the other half";
}

TEST(Unicode, ReadsWindows1252) {
  EXPECT_EQ(utf8FromWindows1252("caf\xE9 \x80 \x93\xDF\x94 \x9F"), "caf\u00E9 \u20AC \u201C\u00DF\u201D \u0178");
  for (const char none : {'\x81', '\x8D', '\x8F', '\x90', '\x9D'}) EXPECT_FALSE(utf8FromWindows1252({&none, 1}));
}

TEST(Unicode, CharactersOfATextAreCounted) {
  EXPECT_EQ(charactersOf("a\u00FC\u20AC\U0001F600"), U"a\u00FC\u20AC\U0001F600");
  EXPECT_EQ(charactersOf("a\xFF"), U"a\uFFFD");
}

TEST(Unicode, ATextIsBlankIfNobodySeesAnyOfIt) {
  for (const char* text : {"", " \r\n", "\u00A0\u3000", "\u200B\u202E\u2069", "\u2800\u3164\uFFA0"})
    EXPECT_TRUE(isBlank(text)) << text;
  for (const char* text : {"a", " .", "\u200B\u00FC", "\x01", "\xFF"}) EXPECT_FALSE(isBlank(text)) << text;
}

}  // namespace
}  // namespace qrelief
