// SPDX-License-Identifier: GPL-3.0-or-later
// Reads our symbols with an independent decoder.
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "messages/sentences.h"
#include "qr/symbol.h"
#include "support/decode_symbol.h"

namespace qrelief {
namespace {

std::string readText(const std::string& text, const SymbolOptions& options = {}) {
  const Result<Symbol> symbol = encodeSymbol(text, options);
  return symbol ? decodeSymbol(*symbol).text() : sentence(symbol.error().message);
}

class EveryLevel : public testing::TestWithParam<ErrorCorrection> {};

TEST_P(EveryLevel, DecodesInAllVersions) {
  for (int version = 1; version <= 40; ++version) {
    // The text fills what the level allows in version 1 and grows with the version; all three modes occur.
    std::string text = "ab:" + std::to_string(version);
    while (text.size() < static_cast<std::size_t>(version * version / 2))
      text += " K" + std::to_string(text.size() * 977);
    const Result<Symbol> symbol = encodeSymbol(text, {.errorCorrection = GetParam(), .version = version});
    ASSERT_TRUE(symbol) << symbol.error().message;
    const ZXing::Result result = decodeSymbol(*symbol);
    EXPECT_EQ(result.text(), text) << "version " << version;
    EXPECT_EQ(result.ecLevel(), errorCorrectionName(GetParam()));
  }
}

INSTANTIATE_TEST_SUITE_P(SymbolReading, EveryLevel,
                         testing::Values(ErrorCorrection::L, ErrorCorrection::M, ErrorCorrection::Q,
                                         ErrorCorrection::H),
                         [](const auto& level) { return std::string(errorCorrectionName(level.param)); });

TEST(SymbolReading, DecodesUtf8Unchanged) {
  for (const std::string text : {"Grüße aus Zürich", "naïve café – “quoted”", "Привет, мир", "日本語のテキスト",
                                 "emoji 🙂🚀 and 0123456789 DIGITS", "line\nbreak\tand tab", "مرحبا 123"}) {
    EXPECT_EQ(readText(text), text);
  }
}

TEST(SymbolReading, NamesUtf8OnlyForTextsBeyondAscii) {
  const auto named = [](const std::string& text, EciUse eci) { return encodeSymbol(text, {.eci = eci})->hasEci; };
  EXPECT_FALSE(named("https://example.com/a1", EciUse::Auto));
  EXPECT_TRUE(named("Zürich", EciUse::Auto));
  EXPECT_FALSE(named("Zürich", EciUse::Never));
  EXPECT_NE(encodeSymbol("Zürich", {.eci = EciUse::Auto})->dark, encodeSymbol("Zürich", {.eci = EciUse::Never})->dark);
  EXPECT_EQ(readText("Zürich 0123456789 SHOP", {.eci = EciUse::Never}), "Zürich 0123456789 SHOP");
}

TEST(SymbolReading, DecodesEveryModeAfterTheCharacterSet) {
  for (const std::string text : {"01234567890123456789 ü", "HTTPS://EXAMPLE.COM/ü", "ü 01234567890123456789",
                                 "BEGIN:VCARD\r\nN:Müller;Jörg\r\nTEL:+491234567890\r\nEND:VCARD", "S:Café \\; Bar;"})
    EXPECT_EQ(readText(text), text);
}

TEST(SymbolReading, DecodesLinksWithMixedModes) {
  const std::string text = "https://example.com/SHOP/0123456789012345678901234567890?ID=ABCDEFGHIJKLMNOP";
  EXPECT_EQ(readText(text), text);
}

TEST(SymbolReading, DecodesTheLongestTexts) {
  const std::string bytes(2331, 'q'), digits(5596, '5');
  EXPECT_EQ(readText(bytes), bytes);
  EXPECT_EQ(readText(digits), digits);
}

TEST(SymbolReading, WorksUnderEveryMask) {
  for (int mask = 0; mask < 8; ++mask)
    EXPECT_EQ(readText("https://qrelief.example", {.maskRule = MaskRule::Fixed, .mask = mask}),
              "https://qrelief.example");
}

}  // namespace
}  // namespace qrelief
