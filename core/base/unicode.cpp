// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/unicode.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "base/unicode_tables.h"
#include "base/utf8.h"

namespace qrelief {
namespace {

using unicode::Pair;

// Hangul syllables are composed by arithmetic [Unicode 15, 3.12].
constexpr char32_t kSyllables = 0xAC00, kLeads = 0x1100, kVowels = 0x1161, kTails = 0x11A7;
constexpr char32_t kLeadCount = 19, kVowelCount = 21, kTailCount = 28;

/// Bytes that are not UTF-8 become characters beyond Unicode, which no table has.
constexpr char32_t kBeyond = 0x110000;

std::u32string decoded(std::string_view utf8) {
  std::u32string text;
  text.reserve(utf8.size());
  for (std::size_t i = 0; i < utf8.size();) {
    const std::size_t length = utf8SequenceLength(utf8.substr(i));
    const auto byte = [&](std::size_t at) { return static_cast<char32_t>(static_cast<unsigned char>(utf8[i + at])); };
    char32_t code = byte(0);
    if (length == 0) code += kBeyond;
    if (length > 1) code &= 0x7Fu >> length;
    for (std::size_t at = 1; at < length; ++at) code = code << 6 | (byte(at) & 0x3F);
    text += code;
    i += std::max<std::size_t>(length, 1);
  }
  return text;
}

std::string encoded(std::u32string_view text) {
  std::string utf8;
  utf8.reserve(text.size());
  for (const char32_t code : text) {
    if (code >= kBeyond)
      utf8 += static_cast<char>(code - kBeyond);
    else
      appendUtf8(utf8, code);
  }
  return utf8;
}

bool isAscii(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

const Pair* findPair(char32_t code) {
  const auto* pair = std::lower_bound(std::begin(unicode::kPairs), std::end(unicode::kPairs), code,
                                      [](const Pair& p, char32_t c) { return p.code < c; });
  return pair != std::end(unicode::kPairs) && pair->code == code ? pair : nullptr;
}

/// Returns the order of a combining mark among its neighbours; 0 for other characters.
int rankOf(char32_t code) {
  const auto* marks = std::lower_bound(std::begin(unicode::kMarks), std::end(unicode::kMarks), code,
                                       [](const unicode::Marks& m, char32_t c) { return m.last < c; });
  return marks != std::end(unicode::kMarks) && marks->first <= code ? marks->rank : 0;
}

void appendDecomposed(std::u32string& text, char32_t code) {
  if (code >= kSyllables && code < kSyllables + kLeadCount * kVowelCount * kTailCount) {
    const char32_t index = code - kSyllables, tail = index % kTailCount;
    text += static_cast<char32_t>(kLeads + index / (kVowelCount * kTailCount));
    text += static_cast<char32_t>(kVowels + index / kTailCount % kVowelCount);
    if (tail > 0) text += static_cast<char32_t>(kTails + tail);
  } else if (const Pair* pair = findPair(code)) {
    appendDecomposed(text, pair->first);  // at most three deep
    if (pair->second != 0) text += pair->second;
  } else {
    text += code;
  }
}

/// Sorts each run of combining marks by rank.
void orderMarks(std::u32string& text) {
  const auto isMark = [](char32_t code) { return rankOf(code) > 0; };
  for (auto begin = text.begin(); begin != text.end();) {
    begin = std::find_if(begin, text.end(), isMark);
    const auto end = std::find_if_not(begin, text.end(), isMark);
    std::stable_sort(begin, end, [](char32_t a, char32_t b) { return rankOf(a) < rankOf(b); });
    begin = end;
  }
}

std::u32string decomposed(std::u32string_view text) {
  std::u32string parts;
  for (const char32_t code : text) appendDecomposed(parts, code);
  orderMarks(parts);
  return parts;
}

/// Returns the character that two compose; 0 if none.
char32_t composition(char32_t first, char32_t second) {
  if (first >= kLeads && first < kLeads + kLeadCount && second >= kVowels && second < kVowels + kVowelCount)
    return kSyllables + ((first - kLeads) * kVowelCount + (second - kVowels)) * kTailCount;
  const bool isOpenSyllable = first >= kSyllables && first < kSyllables + kLeadCount * kVowelCount * kTailCount &&
                              (first - kSyllables) % kTailCount == 0;
  if (isOpenSyllable && second > kTails && second < kTails + kTailCount) return first + (second - kTails);
  const auto byParts = [](const Pair& a, const Pair& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  };
  static const std::vector<Pair> kByParts = [&] {
    std::vector<Pair> pairs;
    std::copy_if(std::begin(unicode::kPairs), std::end(unicode::kPairs), std::back_inserter(pairs),
                 [](const Pair& pair) { return pair.composes; });
    std::sort(pairs.begin(), pairs.end(), byParts);
    return pairs;
  }();
  const auto pair = std::lower_bound(kByParts.begin(), kByParts.end(), Pair{0, first, second, true}, byParts);
  return pair != kByParts.end() && pair->first == first && pair->second == second ? pair->code : 0;
}

/// Composes decomposed text: each mark joins the last character that is no mark, unless one of the same or a higher
/// rank stands between them.
std::u32string recomposed(std::u32string_view parts) {
  std::u32string text;
  std::size_t starter = std::u32string::npos;
  int between = -1;  // rank of the last character after the starter; -1: there is none
  for (const char32_t code : parts) {
    const int rank = rankOf(code);
    if (starter != std::u32string::npos && between < rank) {
      if (const char32_t whole = composition(text[starter], code)) {
        text[starter] = whole;
        continue;
      }
    }
    if (rank == 0) {
      starter = text.size();
      between = -1;
    } else {
      between = rank;
    }
    text += code;
  }
  return text;
}

void appendFolded(std::u32string& text, char32_t code) {
  for (const unicode::LongFold& fold : unicode::kLongFolds) {
    if (fold.code != code) continue;
    for (const char32_t to : fold.to)
      if (to != 0) text += to;
    return;
  }
  const auto* run = std::lower_bound(std::begin(unicode::kFoldRuns), std::end(unicode::kFoldRuns), code,
                                     [](const unicode::FoldRun& r, char32_t c) { return r.last < c; });
  const bool folds = run != std::end(unicode::kFoldRuns) && run->first <= code && (code - run->first) % run->step == 0;
  text += folds ? static_cast<char32_t>(static_cast<std::int32_t>(code) + run->offset) : code;
}

}  // namespace

std::string composed(std::string_view utf8) {
  if (isAscii(utf8)) return std::string(utf8);
  return encoded(recomposed(decomposed(decoded(utf8))));
}

std::string caseFolded(std::string_view utf8) {
  if (isAscii(utf8)) {
    std::string low(utf8);
    for (char& c : low)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return low;
  }
  std::u32string text;
  for (const char32_t code : decomposed(decoded(utf8))) appendFolded(text, code);
  return encoded(recomposed(decomposed(text)));
}

std::optional<std::string> utf8FromUtf16(std::span<const std::uint8_t> bytes, bool isBigEndian) {
  if (bytes.size() % 2 != 0) return std::nullopt;
  const auto unit = [&](std::size_t i) {
    const auto first = static_cast<char32_t>(bytes[i]), second = static_cast<char32_t>(bytes[i + 1]);
    return isBigEndian ? first << 8 | second : second << 8 | first;
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    char32_t code = unit(i);
    if (code == 0xFEFF && i == 0) continue;
    if (code >= 0xDC00 && code < 0xE000) return std::nullopt;
    if (code >= 0xD800 && code < 0xDC00) {
      i += 2;
      const char32_t low = i < bytes.size() ? unit(i) : 0;
      if (low < 0xDC00 || low >= 0xE000) return std::nullopt;
      code = 0x10000 + ((code - 0xD800) << 10 | (low - 0xDC00));
    }
    appendUtf8(text, code);
  }
  return text;
}

std::optional<std::string> utf8FromWindows1252(std::string_view bytes) {
  // 0x80 to 0x9F; the other bytes are as in Latin-1. 0: no character.
  constexpr std::array<char32_t, 32> kC1 = {0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                            0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0,      0x017D, 0,
                                            0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                            0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};
  std::string text;
  text.reserve(bytes.size());
  for (const char byte : bytes) {
    char32_t code = static_cast<unsigned char>(byte);
    if (code >= 0x80 && code < 0xA0) code = kC1[code - 0x80];
    if (code == 0 && byte != '\0') return std::nullopt;
    appendUtf8(text, code);
  }
  return text;
}

void appendUtf8(std::string& text, char32_t code) {
  const auto add = [&](char32_t byte) { text += static_cast<char>(byte); };
  const auto addContinued = [&](int shift) { add(0x80 | (code >> shift & 0x3F)); };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0 | code >> 6);
    addContinued(0);
  } else if (code < 0x10000) {
    add(0xE0 | code >> 12);
    addContinued(6);
    addContinued(0);
  } else {
    add(0xF0 | code >> 18);
    addContinued(12);
    addContinued(6);
    addContinued(0);
  }
}

std::u32string charactersOf(std::string_view utf8) {
  std::u32string text = decoded(utf8);
  std::replace_if(
      text.begin(), text.end(), [](char32_t code) { return code >= kBeyond; }, U'\uFFFD');
  return text;
}

bool isSpace(char32_t c) {
  constexpr std::u32string_view kFillers = U"\u115F\u1160\u2800\u3164\uFFA0";  // of Hangul and Braille
  return c == U' ' || (c >= U'\t' && c <= U'\r') || c == U'\u00A0' || c == U'\u1680' ||
         (c >= U'\u2000' && c <= U'\u200A') || c == U'\u2028' || c == U'\u2029' || c == U'\u202F' || c == U'\u205F' ||
         c == U'\u3000' || kFillers.find(c) != kFillers.npos;
}

bool isUnseen(char32_t c) {
  return c == U'\u00AD' || (c >= U'\u200B' && c <= U'\u200F') || (c >= U'\u202A' && c <= U'\u202E') ||
         (c >= U'\u2060' && c <= U'\u206F') || c == U'\uFEFF';
}

bool isBlank(std::string_view utf8) {
  const std::u32string text = charactersOf(utf8);
  return std::all_of(text.begin(), text.end(), [](char32_t c) { return isSpace(c) || isUnseen(c); });
}

}  // namespace qrelief
