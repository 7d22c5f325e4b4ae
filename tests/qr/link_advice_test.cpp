// SPDX-License-Identifier: GPL-3.0-or-later
#include "qr/link_advice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages/sentences.h"

namespace qrelief {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> codes(std::string_view text) {
  std::vector<std::string> all;
  for (const TextAdvice& advice : adviseText(text)) all.push_back(advice.message.code);
  return all;
}

std::vector<std::string> fixed(std::string_view text) {
  std::vector<std::string> all;
  for (const TextAdvice& advice : adviseText(text)) all.push_back(advice.fixed);
  return all;
}

TEST(LinkAdvice, GoodLinksAndPlainTextsNeedNone) {
  for (const char* text : {"https://example.org/a?b=c#d",
                           "http://192.168.0.1:8080/",
                           "Hello world",
                           "3.14",
                           "a.b c.d",
                           "",
                           "bunny.stl",
                           "name@example.org",
                           "WIFI:T:nopass;S:x;;",
                           "z.B.",
                           "e.g. this",
                           "https://[2001:db8::1]/",
                           "http://localhost:3000/",
                           "HTTPS://EXAMPLE.ORG",
                           "http is a protocol",
                           "\u201CHello\u201D",
                           "12\u00A0mm",
                           "\U0001F468\u200D\U0001F469",
                           "https://user@example.org/",
                           "mailto:a@example.org"})
    EXPECT_THAT(codes(text), IsEmpty()) << text;
}

TEST(LinkAdvice, AnAddressWithoutItsSchemeGetsHttps) {
  for (const std::string text : {"example.org", "www.example.org/a%20b", "EXAMPLE.ORG:8080?x", "b\u00FCcher.example",
                                 "a.co/bunny.stl", "xn--bcher-kva.xn--p1ai"}) {
    EXPECT_THAT(codes(text), ElementsAre("link-without-scheme")) << text;
    EXPECT_THAT(fixed(text), ElementsAre("https://" + text));
  }
  EXPECT_THAT(fixed(" example.org "), ElementsAre("https://example.org"));
}

TEST(LinkAdvice, AMisspeltSchemeIsCorrected) {
  for (const char* text : {"htps://example.org/a", "https:/example.org/a", "https//example.org/a",
                           "http:\\\\example.org/a", "https;//example.org/a", "ttps://example.org/a"}) {
    EXPECT_THAT(codes(text), ElementsAre("link-scheme-misspelt")) << text;
    EXPECT_THAT(fixed(text), ElementsAre("https://example.org/a")) << text;
  }
}

TEST(LinkAdvice, SpacesInAndAroundALinkAreFound) {
  EXPECT_THAT(fixed("https://example.org/a b  c"), ElementsAre("https://example.org/a%20b%20c"));
  EXPECT_THAT(codes("https://example.org/a b"), ElementsAre("link-spaces"));
  EXPECT_THAT(codes("https://example.org/a\n"), ElementsAre("link-ends"));
  EXPECT_THAT(codes("https://example.org/a\u00A0"), ElementsAre("link-ends"));
  EXPECT_THAT(codes("https://example.org/a\u00A0b"), ElementsAre("link-spaces"));
  for (const char* text : {"https://example.org/a\n", "https://example.org/a\u00A0", "\u3000https://example.org/a"})
    EXPECT_THAT(fixed(text), ElementsAre("https://example.org/a"));
}

TEST(LinkAdvice, UnseenCharactersAreFoundAnywhereInALink) {
  for (const char* text : {"https://example.org/a\u200B", "\uFEFFhttps://example.org/a", "https://exam\u00ADple.org/a",
                           "\u202Ahttps://example.org/a\u202C ", "example.org/a\u2060"}) {
    EXPECT_THAT(codes(text), ElementsAre("link-unseen"));
    EXPECT_THAT(fixed(text), ElementsAre("https://example.org/a"));
  }
}

TEST(LinkAdvice, QuotationMarksBracketsAndPunctuationAroundALinkAreFound) {
  for (const char* text :
       {"\u201Chttps://example.org/a\u201D", "\u201Ehttps://example.org/a\u201C", "\"https://example.org/a\"",
        "\u00AB https://example.org/a \u00BB", "<https://example.org/a>", "https://example.org/a\u2019",
        "(https://example.org/a)", "[ example.org/a ]", "\u3010https://example.org/a\u3011"}) {
    EXPECT_THAT(codes(text), ElementsAre("link-quoted")) << text;
    EXPECT_THAT(fixed(text), ElementsAre("https://example.org/a"));
  }
  EXPECT_THAT(codes("https://example.org/a_(b)"), IsEmpty());
  EXPECT_THAT(codes("https://example.org/?q=\"b\""), IsEmpty());
  EXPECT_THAT(codes("https://example.org/\u2018b\u2019"), IsEmpty());
  EXPECT_THAT(codes("https://example.org/a."), ElementsAre("link-punctuation"));
  EXPECT_THAT(fixed("https://example.org/a.,"), ElementsAre("https://example.org/a"));
}

TEST(LinkAdvice, ATextThatOnlyStartsLikeALinkIsReported) {
  for (const char* text : {"https://", "https://x", "http://exa%mple.org", "https://example.org:99999/"})
    EXPECT_THAT(codes(text), ElementsAre("link-incomplete")) << text;
}

TEST(LinkAdvice, ANameInOtherLettersCanBeWrittenInAscii) {
  EXPECT_THAT(codes("https://B\u00FCcher.example:8080/\u00DCber?x=\u00FC"), ElementsAre("link-other-letters"));
  EXPECT_THAT(fixed("https://B\u00FCcher.example:8080/\u00DCber?x=\u00FC"),
              ElementsAre("https://xn--bcher-kva.example:8080/\u00DCber?x=\u00FC"));
  EXPECT_THAT(fixed("https://\u043F\u0440\u0438\u043C\u0435\u0440.\u0440\u0444/"),
              ElementsAre("https://xn--e1afmkfd.xn--p1ai/"));
  EXPECT_THAT(fixed("https://\u4F8B\u3048.jp/"), ElementsAre("https://xn--r8jz45g.jp/"));
}

TEST(LinkAdvice, OnlyTrackingParametersAreRemoved) {
  EXPECT_THAT(fixed("https://e.org/?utm_source=a&b=%20&fbclid=1&c#d?utm_x=1"),
              ElementsAre("https://e.org/?b=%20&c#d?utm_x=1"));
  EXPECT_THAT(fixed("https://e.org/p?gclid=1"), ElementsAre("https://e.org/p"));
  EXPECT_THAT(fixed("https://e.org/p?q=utm_source"), IsEmpty());
  EXPECT_EQ(adviseText("https://e.org/?gclid=1")[0].severity, TextAdvice::Severity::Note);
  const auto longer = adviseText("https://example.org/page?utm_campaign=" + std::string(50, 'x'));
  ASSERT_EQ(longer.size(), 1u);
  EXPECT_EQ(longer[0].severity, TextAdvice::Severity::Warning);
  EXPECT_EQ(sentence(longer[0].message), "64 characters of the link only track visitors");
}

TEST(LinkAdvice, CapitalsAreNamedOnlyIfTheyGiveASmallerSymbol) {
  const auto note = adviseCapitals("https://a-rather-long-name.example.org/", {});
  ASSERT_TRUE(note.has_value());
  EXPECT_EQ(sentence(*note), "With scheme and host in capitals, the code would be smaller: version 2 in place of 3");
  EXPECT_FALSE(adviseCapitals("https://e.org", {})) << "14 bytes fit version 1";
  EXPECT_FALSE(adviseCapitals("https://a-rather-long-name.example.org/", {.version = 3}));
  EXPECT_FALSE(adviseCapitals("no link", {}));
}

std::vector<std::pair<std::string, std::string>> forms(std::string_view link) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const ShorterForm& form : shorterForms(link)) all.emplace_back(shorterFormName(form.kind), form.text);
  return all;
}

TEST(LinkAdvice, SchemeAndHostMayBeCapitalsAndTheRestStays) {
  using testing::Pair;
  EXPECT_THAT(forms("https://en.wikipedia.org/wiki/QR_code"),
              ElementsAre(Pair("capitals", "HTTPS://EN.WIKIPEDIA.ORG/wiki/QR_code")));
  EXPECT_THAT(forms("https://example.org/"), ElementsAre(Pair("capitals", "HTTPS://EXAMPLE.ORG")));
  EXPECT_THAT(forms("https://example.org/?a=b"), ElementsAre(Pair("capitals", "HTTPS://EXAMPLE.ORG/?a=b")));
  EXPECT_THAT(forms("https://www.example.org/a#:~:text=some%20words"),
              ElementsAre(Pair("capitals", "HTTPS://WWW.EXAMPLE.ORG/a#:~:text=some%20words"),
                          Pair("www", "HTTPS://EXAMPLE.ORG/a#:~:text=some%20words"),
                          Pair("highlight", "https://www.example.org/a")));
  EXPECT_THAT(forms("https://www.org/"), ElementsAre(Pair("capitals", "HTTPS://WWW.ORG")));
  for (const char* text : {"hello", "https://b\u00FCcher.example/", "https://user@example.org/", "HTTPS://EXAMPLE.ORG",
                           "mailto:a@example.org"})
    EXPECT_THAT(forms(text), IsEmpty()) << text;
}

}  // namespace
}  // namespace qrelief
