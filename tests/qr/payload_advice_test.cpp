// SPDX-License-Identifier: GPL-3.0-or-later
#include "qr/payload_advice.h"

#include <gtest/gtest.h>

#include "messages/sentences.h"
#include "qr/link_advice.h"

namespace qrelief {
namespace {

std::string codeFor(std::string_view text) {
  const auto advice = advisePayload(text);
  return advice ? std::string(advice->code) : "none";
}

TEST(PayloadAdvice, GoodTextsNeedNone) {
  for (const char* text :
       {"WIFI:T:WPA;S:Caf\u00E9;P:a b c d e;;", "WIFI:S:x\\;y\\\\;T:WPA;P:a\\:b\\,c\\\"d;H:true;;",
        "WIFI:T:nopass;S:x;", "WIFI:T:WPA2-EAP;S:x;E:PEAP;PH2:MSCHAPV2;I:me;P:secret;;",
        "BEGIN:VCARD\nVERSION:3.0\nN:M\u00FCller;Hans\nEND:VCARD", "BEGIN:VCARD\r\nFN:x\r\nEND:VCARD\r\n",
        "begin:vcard\nfn:x\nend:vcard", "WiFi is free", "https://example.org", ""})
    EXPECT_EQ(codeFor(text), "none") << text;
}

TEST(PayloadAdvice, ASemicolonInAValueNeedsABackslash) {
  EXPECT_EQ(codeFor("WIFI:T:WPA;S:my;net;P:abc;;"), "wifi-part-without-key");
  EXPECT_EQ(codeFor("WIFI:T:WPA;S:net;P:a;b:c;;"), "wifi-part-without-key");
  EXPECT_EQ(sentence(*advisePayload("WIFI:T:WPA;S:my;net;P:abc;;")),
            "Phones do not understand part 3 of the Wi-Fi text; parts end with semicolons");
}

TEST(PayloadAdvice, EveryPartOfAWifiTextEndsWithASemicolon) {
  EXPECT_EQ(codeFor("WIFI:T:WPA;S:net;P:secret"), "wifi-part-without-end");
  EXPECT_EQ(codeFor("WIFI:T:WPA;S:net;P:secret\\;"), "wifi-part-without-end");
}

TEST(PayloadAdvice, AWifiTextNamesItsNetworkAndBeginsInCapitals) {
  EXPECT_EQ(codeFor("WIFI:T:WPA;P:secret;;"), "wifi-without-name");
  EXPECT_EQ(codeFor("WIFI:T:WPA;S:;P:secret;;"), "wifi-without-name");
  EXPECT_EQ(codeFor("WIFI:"), "wifi-without-name");
  EXPECT_EQ(codeFor("wifi:T:WPA;S:net;P:secret;;"), "wifi-small-letters");
}

TEST(PayloadAdvice, AContactEndsWithALineOfItsOwn) {
  for (const char* text :
       {"BEGIN:VCARD\nFN:x", "BEGIN:VCARD VERSION:3.0 FN:x END:VCARD", "BEGIN:VCARD\\nFN:x\\nEND:VCARD", "BEGIN:VCARD"})
    EXPECT_EQ(codeFor(text), "contact-without-end") << text;
}

TEST(PayloadAdvice, IsAmongTheAdviceOnTexts) {
  const auto advice = adviseText("WIFI:T:WPA;S:net;P:secret");
  ASSERT_EQ(advice.size(), 1u);
  EXPECT_EQ(advice[0].severity, TextAdvice::Severity::Warning);
  EXPECT_EQ(advice[0].message.code, "wifi-part-without-end");
}

}  // namespace
}  // namespace qrelief
