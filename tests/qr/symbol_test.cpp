// SPDX-License-Identifier: GPL-3.0-or-later
#include "qr/symbol.h"

#include <algorithm>
#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "messages/sentences.h"

namespace qrelief {
namespace {

using testing::ElementsAreArray;
using testing::HasSubstr;

constexpr ErrorCorrection kLevels[] = {ErrorCorrection::L, ErrorCorrection::M, ErrorCorrection::Q, ErrorCorrection::H};

Symbol encoded(const std::string& text, const SymbolOptions& options = {}) {
  const Result<Symbol> symbol = encodeSymbol(text, options);
  EXPECT_TRUE(symbol) << symbol.error().message;
  return symbol.value_or(Symbol{});
}

Error refused(const std::string& text, const SymbolOptions& options = {}) {
  const Result<Symbol> symbol = encodeSymbol(text, options);
  EXPECT_FALSE(symbol);
  return symbol ? Error{} : symbol.error();
}

long countRole(const Symbol& symbol, ModuleRole role) {
  return std::count(symbol.roles.begin(), symbol.roles.end(), role);
}

/// Returns the number of alignment patterns along one axis; 0 in version 1.
int alignmentPatternsPerSide(int version) { return version == 1 ? 0 : version / 7 + 2; }

int withCheckBits(int value, int checkBits, int generator) {
  int remainder = value << checkBits;
  for (int bit = 31 - checkBits; bit >= 0; --bit) {
    if (remainder >> (bit + checkBits) & 1) remainder ^= generator << bit;
  }
  return value << checkBits | remainder;
}

int formatInformation(ErrorCorrection level, int mask) {
  const int levelBits[] = {0b01, 0b00, 0b11, 0b10};
  return withCheckBits(levelBits[static_cast<int>(level)] << 3 | mask, 10, 0b10100110111) ^ 0b101010000010010;
}

/// Reads both copies, most significant bit first [ISO/IEC 18004, figure 25].
std::pair<int, int> readFormatInformation(const Symbol& symbol) {
  const int n = symbol.size;
  int first = 0, second = 0;
  const auto add = [&](int& value, int row, int column) { value = value << 1 | symbol.isDark(row, column); };
  for (int column : {0, 1, 2, 3, 4, 5, 7, 8}) add(first, 8, column);
  for (int row : {7, 5, 4, 3, 2, 1, 0}) add(first, row, 8);
  for (int i = 1; i <= 7; ++i) add(second, n - i, 8);
  for (int i = 8; i >= 1; --i) add(second, 8, n - i);
  return {first, second};
}

bool maskInverts(int mask, int i, int j) {
  switch (mask) {
    case 0:
      return (i + j) % 2 == 0;
    case 1:
      return i % 2 == 0;
    case 2:
      return j % 3 == 0;
    case 3:
      return (i + j) % 3 == 0;
    case 4:
      return (i / 2 + j / 3) % 2 == 0;
    case 5:
      return i * j % 2 + i * j % 3 == 0;
    case 6:
      return (i * j % 2 + i * j % 3) % 2 == 0;
    default:
      return ((i + j) % 2 + i * j % 3) % 2 == 0;
  }
}

/// Reads the codewords in placement order: two columns at a time from the right, alternately up and down.
std::vector<int> readCodewords(const Symbol& symbol) {
  std::vector<int> codewords;
  int bits = 0, count = 0;
  bool upwards = true;
  for (int right = symbol.size - 1; right > 0; right -= 2, upwards = !upwards) {
    if (right == 6) right = 5;
    for (int step = 0; step < symbol.size; ++step) {
      const int row = upwards ? symbol.size - 1 - step : step;
      for (int column : {right, right - 1}) {
        if (symbol.role(row, column) != ModuleRole::Data) continue;
        bits = bits << 1 | (symbol.isDark(row, column) != maskInverts(symbol.mask, row, column));
        if (++count % 8 != 0) continue;
        codewords.push_back(bits & 0xFF);
      }
    }
  }
  return codewords;
}

TEST(Symbol, EqualsTheExampleOfTheStandard) {
  const Symbol symbol = encoded("01234567");
  EXPECT_EQ(symbol.version, 1);
  EXPECT_EQ(symbol.size, 21);
  // ISO/IEC 18004, annex I: data, padding and error correction codewords of "01234567" in 1-M.
  const std::vector<int> expected = {0x10, 0x20, 0x0C, 0x56, 0x61, 0x80, 0xEC, 0x11, 0xEC, 0x11, 0xEC, 0x11, 0xEC,
                                     0x11, 0xEC, 0x11, 0xA5, 0x24, 0xD4, 0xC1, 0xED, 0x36, 0xC7, 0x87, 0x2C, 0x55};
  EXPECT_THAT(readCodewords(symbol), ElementsAreArray(expected));
}

TEST(Symbol, WritesTheFormatInformationOfItsLevelAndMaskTwice) {
  EXPECT_EQ(formatInformation(ErrorCorrection::M, 2), 0b101111001111100);  // the standard's own example
  for (const ErrorCorrection level : kLevels) {
    for (const int version : {1, 2, 7, 14, 40}) {
      const Symbol symbol = encoded("QR code", {.errorCorrection = level, .version = version});
      EXPECT_EQ(symbol.errorCorrection, level);
      const int expected = formatInformation(level, symbol.mask);
      EXPECT_EQ(readFormatInformation(symbol), std::pair(expected, expected))
          << errorCorrectionName(level) << version << " mask " << symbol.mask;
    }
  }
}

TEST(Symbol, GivesEveryRoleAsManyModulesAsTheStandard) {
  for (int version = 1; version <= 40; ++version) {
    const Symbol symbol = encoded("x", {.version = version});
    const int n = 17 + 4 * version, a = alignmentPatternsPerSide(version);
    const int alignment = a == 0 ? 0 : 25 * (a * a - 3);
    const int crossings = a < 3 ? 0 : 2 * (a - 2);  // alignment patterns that cross a timing pattern
    const int timing = 2 * (n - 16) - 5 * crossings;
    const int versionInformation = version < 7 ? 0 : 36;
    ASSERT_EQ(symbol.size, n);
    ASSERT_EQ(symbol.roles.size(), static_cast<std::size_t>(n * n));
    ASSERT_EQ(symbol.dark.size(), static_cast<std::size_t>(n * n));
    EXPECT_EQ(countRole(symbol, ModuleRole::Finder), 3 * 49) << version;
    EXPECT_EQ(countRole(symbol, ModuleRole::Separator), 3 * 15) << version;
    EXPECT_EQ(countRole(symbol, ModuleRole::Alignment), alignment) << version;
    EXPECT_EQ(countRole(symbol, ModuleRole::Timing), timing) << version;
    EXPECT_EQ(countRole(symbol, ModuleRole::Format), 31) << version;
    EXPECT_EQ(countRole(symbol, ModuleRole::Version), versionInformation) << version;
    EXPECT_EQ(countRole(symbol, ModuleRole::Data), n * n - 147 - 45 - alignment - timing - 31 - versionInformation)
        << version;
  }
}

TEST(Symbol, HasAsManyDataModulesAsTheTableOfTheStandard) {
  // Codewords and remainder bits of ISO/IEC 18004, table 1.
  const struct {
    int version, codewords, remainder;
  } rows[] = {{1, 26, 0},   {2, 44, 7},    {6, 172, 7},   {7, 196, 0},
              {14, 581, 3}, {21, 1156, 4}, {28, 1921, 3}, {40, 3706, 0}};
  for (const auto& row : rows) {
    const Symbol symbol = encoded("x", {.version = row.version});
    EXPECT_EQ(countRole(symbol, ModuleRole::Data), 8 * row.codewords + row.remainder) << row.version;
  }
}

TEST(Symbol, DrawsFindersSeparatorsAndTimingWhereTheStandardHasThem) {
  for (const int version : {1, 2, 7, 21}) {
    const Symbol symbol = encoded("x", {.version = version});
    const int n = symbol.size;
    const std::pair<int, int> corners[] = {{0, 0}, {0, n - 7}, {n - 7, 0}};
    for (const auto& [top, left] : corners) {
      for (int row = -1; row <= 7; ++row) {
        for (int column = -1; column <= 7; ++column) {
          const int y = top + row, x = left + column;
          if (y < 0 || x < 0 || y >= n || x >= n) continue;
          const int ring = std::max(std::abs(row - 3), std::abs(column - 3));
          EXPECT_EQ(symbol.role(y, x), ring <= 3 ? ModuleRole::Finder : ModuleRole::Separator) << y << ' ' << x;
          EXPECT_EQ(symbol.isDark(y, x), ring == 3 || ring <= 1) << y << ' ' << x;
        }
      }
    }
    for (int i = 8; i < n - 8; ++i) {
      // Alignment patterns that cross the timing pattern are in step with it.
      EXPECT_EQ(symbol.isDark(6, i), i % 2 == 0);
      EXPECT_EQ(symbol.isDark(i, 6), i % 2 == 0);
    }
    EXPECT_TRUE(symbol.isDark(4 * version + 9, 8));
    EXPECT_EQ(symbol.role(4 * version + 9, 8), ModuleRole::Format);
  }
}

TEST(Symbol, PutsAlignmentPatternsOfVersion7AtTheirPlaces) {
  const Symbol symbol = encoded("x", {.version = 7});
  const std::pair<int, int> centres[] = {{6, 22}, {22, 6}, {22, 22}, {22, 38}, {38, 22}, {38, 38}};
  for (const auto& [y, x] : centres) {
    for (int row = -2; row <= 2; ++row) {
      for (int column = -2; column <= 2; ++column) {
        EXPECT_EQ(symbol.role(y + row, x + column), ModuleRole::Alignment);
        EXPECT_EQ(symbol.isDark(y + row, x + column), std::max(std::abs(row), std::abs(column)) != 1);
      }
    }
  }
}

TEST(Symbol, WritesTheVersionInformationTwice) {
  EXPECT_EQ(withCheckBits(7, 12, 0b1111100100101), 0b000111110010010100);  // the standard's own example
  for (const int version : {7, 12, 25, 40}) {
    const Symbol symbol = encoded("x", {.version = version});
    int above = 0, beside = 0;
    for (int bit = 17; bit >= 0; --bit) {
      const int along = bit / 3, across = symbol.size - 11 + bit % 3;
      EXPECT_EQ(symbol.role(along, across), ModuleRole::Version);
      EXPECT_EQ(symbol.role(across, along), ModuleRole::Version);
      above = above << 1 | symbol.isDark(along, across);
      beside = beside << 1 | symbol.isDark(across, along);
    }
    EXPECT_EQ(above, withCheckBits(version, 12, 0b1111100100101));
    EXPECT_EQ(beside, above);
  }
}

TEST(Symbol, IsTheSmallestThatHoldsTheText) {
  // Capacities of ISO/IEC 18004, table 7: digits, alphanumeric characters, bytes.
  const struct {
    ErrorCorrection level;
    int version, digits, alphanumeric, bytes;
  } rows[] = {{ErrorCorrection::L, 1, 41, 25, 17},        {ErrorCorrection::M, 1, 34, 20, 14},
              {ErrorCorrection::Q, 3, 77, 47, 32},        {ErrorCorrection::H, 5, 106, 64, 44},
              {ErrorCorrection::L, 9, 552, 335, 230},     {ErrorCorrection::M, 10, 513, 311, 213},
              {ErrorCorrection::M, 26, 2544, 1542, 1059}, {ErrorCorrection::Q, 27, 1933, 1172, 805}};
  for (const auto& row : rows) {
    const auto version = [&](char character, int count) {
      return encoded(std::string(static_cast<std::size_t>(count), character), {.errorCorrection = row.level}).version;
    };
    EXPECT_EQ(version('7', row.digits), row.version);
    EXPECT_EQ(version('7', row.digits + 1), row.version + 1);
    EXPECT_EQ(version('K', row.alphanumeric), row.version);
    EXPECT_EQ(version('K', row.alphanumeric + 1), row.version + 1);
    EXPECT_EQ(version('k', row.bytes), row.version);
    EXPECT_EQ(version('k', row.bytes + 1), row.version + 1);
  }
}

TEST(Symbol, HoldsAsMuchAsTheLargestSymbolOfTheStandard) {
  const struct {
    ErrorCorrection level;
    std::size_t digits, bytes;
  } rows[] = {{ErrorCorrection::L, 7089, 2953},
              {ErrorCorrection::M, 5596, 2331},
              {ErrorCorrection::Q, 3993, 1663},
              {ErrorCorrection::H, 3057, 1273}};
  for (const auto& row : rows) {
    EXPECT_EQ(encoded(std::string(row.digits, '9'), {.errorCorrection = row.level}).version, 40);
    EXPECT_EQ(encoded(std::string(row.bytes, 'z'), {.errorCorrection = row.level}).version, 40);
    refused(std::string(row.digits + 1, '9'), {.errorCorrection = row.level});
    refused(std::string(row.bytes + 1, 'z'), {.errorCorrection = row.level});
  }
}

TEST(Symbol, MixesModesIfThatSavesAVersion) {
  // 17 bytes fill 1-L; digits in numeric mode take less room.
  EXPECT_EQ(encoded("ab0123456789012345678901", {.errorCorrection = ErrorCorrection::L}).version, 1);
}

TEST(Symbol, OfAsciiIsTheSameWhateverTheCharacterSetSetting) {
  for (const char* text : {"https://example.com/a1", "01234567", "WIFI:T:nopass;S:x;;"}) {
    const Symbol named = encoded(text, {.eci = EciUse::Auto}), plain = encoded(text, {.eci = EciUse::Never});
    EXPECT_EQ(named.dark, plain.dark) << text;
    EXPECT_FALSE(named.hasEci) << text;
  }
}

TEST(Symbol, NeedsRoomToNameTheCharacterSet) {
  // 14 bytes fill 1-M; libqrencode holds 11 beside the character set.
  const std::string thirteen = "abcdefghijk\u00FC", eleven = "abcdefghi\u00FC";
  EXPECT_EQ(encoded(eleven).version, 1);
  EXPECT_EQ(encoded(thirteen).version, 2);
  EXPECT_EQ(encoded(thirteen, {.eci = EciUse::Never}).version, 1);
  EXPECT_TRUE(encoded(eleven).hasEci);
  EXPECT_FALSE(encoded(eleven, {.eci = EciUse::Never}).hasEci);
}

TEST(Symbol, SmallestVersionsByLengthCountTheCharacterSet) {
  for (const EciUse eci : {EciUse::Auto, EciUse::Never}) {
    VersionsByLength versions(ErrorCorrection::M, eci);
    for (std::size_t length = 1; length < 300; ++length) {
      const std::string ascii(length, 'k'), beyond = ascii + "\u00FC";
      EXPECT_EQ(versions.smallest(ascii), encoded(ascii, {.eci = eci}).version) << length;
      EXPECT_EQ(versions.smallest(beyond), encoded(beyond, {.eci = eci}).version) << length;
    }
  }
}

TEST(Symbol, UsesALargerVersionOnRequest) {
  const Symbol symbol = encoded("A", {.errorCorrection = ErrorCorrection::H, .version = 12});
  EXPECT_EQ(symbol.version, 12);
  EXPECT_EQ(symbol.size, 65);
}

TEST(Symbol, IsDeterministic) {
  const Symbol first = encoded("https://example.com/a"), second = encoded("https://example.com/a");
  EXPECT_EQ(first.dark, second.dark);
  EXPECT_EQ(first.mask, second.mask);
}

TEST(Symbol, RefusesATextTooLongForTheVersionAndNamesVersionAndLevelThatFit) {
  const Error error = refused(std::string(100, 'x'), {.errorCorrection = ErrorCorrection::M, .version = 5});
  EXPECT_EQ(error.kind, ErrorKind::BadInput);
  EXPECT_EQ(sentence(error.message),
            "The text is 100 bytes long, too long for a version 5 QR Code with error correction M");
  EXPECT_EQ(hint(error.message), "Use version 6, or version 5 with error correction L, or shorten the text");
}

TEST(Symbol, NamesTheVersionOnlyIfNoWeakerLevelHelps) {
  const Error error = refused(std::string(100, 'x'), {.errorCorrection = ErrorCorrection::L, .version = 2});
  EXPECT_EQ(hint(error.message), "Use version 5, or shorten the text");
}

TEST(Symbol, SuggestsAWeakerLevelIfNoVersionHoldsTheText) {
  const Error error = refused(std::string(2400, 'x'), {.errorCorrection = ErrorCorrection::M});
  EXPECT_EQ(sentence(error.message), "The text is 2400 bytes long, too long for any QR Code with error correction M");
  EXPECT_EQ(hint(error.message), "Use version 36 with error correction L, or shorten the text");
}

TEST(Symbol, RefusesATextThatFitsNoSymbol) {
  for (const std::size_t length : {2954u, 7090u, 100'000'000u}) {
    const Error error = refused(std::string(length, 'x'));
    EXPECT_EQ(error.kind, ErrorKind::BadInput);
    EXPECT_THAT(sentence(error.message), HasSubstr(std::to_string(length) + " bytes long, too long for any QR Code"));
    EXPECT_THAT(hint(error.message), HasSubstr("2953 bytes"));
  }
}

TEST(Symbol, RefusesAnEmptyText) {
  EXPECT_EQ(refused("").kind, ErrorKind::BadInput);
  EXPECT_EQ(sentence(refused("").message), "The text is empty");
}

TEST(Symbol, RefusesATextOfCharactersThatNobodySees) {
  for (const char* text : {" ", " \t\n", "\u00A0", "\u200B\u2060", "\u3164", "\uFEFF \u00AD"})
    EXPECT_EQ(sentence(refused(text).message), "The text has only characters that nobody sees, such as spaces") << text;
}

TEST(Symbol, RefusesNulAndReportsItsPlace) {
  EXPECT_EQ(sentence(refused(std::string("ab\0c", 4)).message), "The text holds a NUL character at byte 3");
}

TEST(Symbol, RefusesInvalidUtf8AndReportsItsPlace) {
  const std::pair<const char*, int> broken[] = {{"ab\xff", 3},            // never in UTF-8
                                                {"a\x80", 2},             // continuation without lead
                                                {"\xc3", 1},              // truncated
                                                {"\xe2\x82", 1},          // truncated
                                                {"x\xf0\x9f\x98", 2},     // truncated
                                                {"\xc0\xaf", 1},          // overlong
                                                {"\xe0\x9f\xbf", 1},      // overlong
                                                {"\xf0\x8f\xbf\xbf", 1},  // overlong
                                                {"\xed\xa0\x80", 1},      // surrogate
                                                {"\xf4\x90\x80\x80", 1},  // beyond U+10FFFF
                                                {"caf\xe9 latin-1", 4}};
  for (const auto& [text, byte] : broken) {
    const Error error = refused(text);
    EXPECT_EQ(error.kind, ErrorKind::BadInput);
    EXPECT_EQ(sentence(error.message), "The text is not valid UTF-8 at byte " + std::to_string(byte));
  }
}

TEST(Symbol, RefusesVersionsThatDoNotExist) {
  for (const int version : {0, -1, 41}) {
    const Error error = refused("x", {.version = version});
    EXPECT_EQ(error.kind, ErrorKind::BadUsage);
    EXPECT_THAT(sentence(error.message), HasSubstr(std::to_string(version)));
  }
}

TEST(ErrorCorrection, IsFoundByItsLetter) {
  for (const ErrorCorrection level : kLevels) EXPECT_EQ(errorCorrectionByName(errorCorrectionName(level)), level);
  EXPECT_EQ(errorCorrectionName(ErrorCorrection::Q), "Q");
  EXPECT_EQ(errorCorrectionByName("X"), std::nullopt);
  EXPECT_EQ(errorCorrectionByName(""), std::nullopt);
}

}  // namespace
}  // namespace qrelief
