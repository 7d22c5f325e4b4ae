// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_stl.h"

#include <algorithm>
#include <cmath>

#include "io/parse_number.h"
#include "io/polygon_list.h"
#include "io/text_scanner.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

constexpr std::size_t kHeaderBytes = 84;  // 80 of free text, 4 of count
constexpr std::size_t kFacetBytes = 50;   // normal, three corners, two bytes of attributes

std::uint64_t announcedFacets(std::span<const std::uint8_t> bytes) {
  return loadBytes<std::uint32_t>(bytes.data() + 80);
}

bool equalsIgnoringCase(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

/// Returns true for a keyword of an ASCII STL that stands only within a solid.
bool isKeywordOfSolids(std::string_view word) {
  for (const std::string_view keyword :
       {"endsolid", "facet", "outer", "loop", "vertex", "endloop", "endfacet", "normal", "end"})
    if (equalsIgnoringCase(word, keyword)) return true;
  return false;
}

/// Skips the name of a solid: to the end of the line or, in a file of one line, to its first facet.
/// @returns true if it stopped before a facet
bool skipName(TextScanner& scanner) {
  for (TextScanner before = scanner;; before = scanner) {
    const std::string_view word = scanner.wordOnLine();
    if (word.empty()) break;
    if (!equalsIgnoringCase(word, "facet")) continue;
    TextScanner after = scanner;
    if (!equalsIgnoringCase(after.wordOnLine(), "normal")) continue;
    for (int axis = 0; axis < 3; ++axis) after.wordOnLine();
    if (!equalsIgnoringCase(after.wordOnLine(), "outer")) continue;
    scanner = before;
    return true;
  }
  scanner.restOfLine();
  return false;
}

bool isFinite(Vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

void addFacet(PolygonSoup& soup, const std::array<Vec3, 3>& corners) {
  const auto first = static_cast<std::uint32_t>(soup.positions.size());
  soup.positions.insert(soup.positions.end(), corners.begin(), corners.end());
  soup.triangles.push_back({first, first + 1, first + 2});
}

constexpr std::size_t kFacetsLookedAt = 64;
constexpr std::size_t kLinesLookedAt = 8;  // for the first facet of an ASCII STL

/// Returns true if all nine coordinates have a plausible size. One in 20,000 facets of random bytes does, because about
/// a third of a float's exponents are plausible.
bool looksLikeFacet(const std::uint8_t* facet) {
  for (std::size_t i = 3; i < 12; ++i) {
    const float size = std::abs(loadBytes<float>(facet + 4 * i));
    if (!(size == 0 || (size > 1e-12f && size < 1e12f))) return false;
  }
  return true;
}

/// Returns true if half of the first facets look valid. A file without a whole facet passes if the declared number is
/// within the limit. Text does not look valid, because a facet's attributes are usually zeros and its characters are
/// not.
bool looksLikeFacets(std::span<const std::uint8_t> bytes, const ReadLimits& limits) {
  const std::size_t present = (bytes.size() - kHeaderBytes) / kFacetBytes;
  if (present == 0) return announcedFacets(bytes) <= limits.maxTriangles;
  const std::size_t looked = std::min(present, kFacetsLookedAt);
  const auto facets = bytes.subspan(kHeaderBytes, kFacetBytes * looked);
  if (std::none_of(facets.begin(), facets.end(), [](std::uint8_t b) { return b < '\t'; })) return false;
  std::size_t good = 0;
  for (std::size_t f = 0; f < looked; ++f) good += looksLikeFacet(facets.data() + kFacetBytes * f);
  return 2 * good >= looked;
}

/// Returns true if the file ends with a facet. Programs that cannot go back in a file leave a wrong count in its
/// header.
bool hasWholeFacets(std::span<const std::uint8_t> bytes) {
  return bytes.size() > kHeaderBytes && (bytes.size() - kHeaderBytes) % kFacetBytes == 0;
}

Status checkBinarySize(std::span<const std::uint8_t> bytes, const ReadLimits& limits) {
  if (bytes.size() < kHeaderBytes)
    return badInput(message<"stl-too-short">(with::count<"count">(bytes.size()), with::count<"header">(kHeaderBytes)));
  const std::uint64_t announced = announcedFacets(bytes);
  const std::uint64_t expected = kHeaderBytes + kFacetBytes * announced;
  const std::size_t rest = bytes.size() - kHeaderBytes;
  if (announced == 0 && rest == 0) return badInput(message<"stl-no-facet">());
  if (hasWholeFacets(bytes) && (announced == 0 || bytes.size() < expected) && looksLikeFacets(bytes, limits)) return {};
  if (announced == 0)
    return badInput(
        message<"stl-announces-none">(with::count<"bytes">(rest), with::count<"count">(rest / kFacetBytes)));
  if (bytes.size() >= expected) return {};
  if (!looksLikeFacets(bytes, limits))
    return badInput(message<"stl-neither">(with::count<"announced">(announced), with::count<"expected">(expected),
                                           with::count<"bytes">(bytes.size())));
  return badInput(message<"stl-cut-off">(with::count<"announced">(announced), with::count<"expected">(expected),
                                         with::count<"bytes">(bytes.size()), with::count<"count">(rest / kFacetBytes)));
}

Result<PolygonSoup> readBinary(std::span<const std::uint8_t> bytes, const ReadLimits& limits) {
  QRELIEF_TRY(checkBinarySize(bytes, limits));
  const std::uint64_t announced = announcedFacets(bytes);
  const std::size_t present = (bytes.size() - kHeaderBytes) / kFacetBytes;
  const bool isWrong = announced == 0 || announced > present;
  const std::size_t count = isWrong ? present : static_cast<std::size_t>(announced);
  if (count > limits.maxTriangles) return tooManyTriangles(limits.maxTriangles);

  PolygonSoup soup;
  soup.format = "STL (binary)";
  soup.positions.reserve(3 * count);
  soup.triangles.reserve(count);
  for (std::size_t f = 0; f < count; ++f) {
    const std::uint8_t* facet = bytes.data() + kHeaderBytes + kFacetBytes * f;
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      for (int axis = 0; axis < 3; ++axis)
        corners[k][axis] = loadBytes<float>(facet + 12 + 12 * k + 4 * static_cast<std::size_t>(axis));
    for (const Vec3& p : corners)
      if (!isFinite(p))
        return badInput(message<"stl-not-finite">(with::index<"facet">(f + 1), with::count<"facets">(count),
                                                  with::term<"at">(coordinates(p))));
    addFacet(soup, corners);
  }
  if (isWrong)
    soup.warnings.push_back(
        message<"stl-wrong-count">(with::count<"announced">(announced), with::count<"count">(count)));
  if (const std::size_t rest = bytes.size() - kHeaderBytes - kFacetBytes * count; rest > 0)
    soup.warnings.push_back(message<"stl-trailing-bytes">(with::count<"count">(rest), with::count<"announced">(count)));
  return soup;
}

class AsciiReader {
 public:
  AsciiReader(std::string_view text, const ReadLimits& limits) : scanner_(text), limits_(limits) {}

  Result<PolygonSoup> read() {
    soup_.format = "STL (ASCII)";
    bool insideSolid = false;
    for (std::string_view word = nextWord(); !word.empty(); word = nextWord()) {
      if (equalsIgnoringCase(word, "solid")) {
        unended_ += insideSolid;
        skipName(scanner_);
        insideSolid = true;
      } else if (insideSolid && equalsIgnoringCase(word, "endsolid")) {
        insideSolid = skipName(scanner_);
      } else if (insideSolid && equalsIgnoringCase(word, "facet")) {
        QRELIEF_TRY(readFacet());
      } else if (isKeywordOfSolids(word)) {
        return unexpected(word, insideSolid ? message<"stl-wants-facet">() : wantsKeyword("solid"));
      } else {  // colours or attributes, which some programs write, or a footer added by a mail server
        if (++linesSkipped_ == 1) firstLineSkipped_ = scanner_.line();
        scanner_.restOfLine();
      }
    }
    if (soup_.triangles.empty()) return badInput(message<"stl-ascii-no-facet">());
    if (linesSkipped_ > 0)
      soup_.warnings.push_back(message<"stl-words-between-facets">(with::count<"count">(linesSkipped_),
                                                                   with::index<"line">(firstLineSkipped_)));
    if (insideSolid || unended_ > 0) soup_.warnings.push_back(message<"stl-no-endsolid">());
    return std::move(soup_);
  }

 private:
  static Message wantsKeyword(std::string_view keyword) {
    return message<"stl-wants-keyword">(with::quoted<"keyword">(keyword));
  }

  tl::unexpected<Error> unexpected(std::string_view word, Message expected) const {
    if (word.empty())
      return badInput(message<"stl-ascii-ends">(with::index<"line">(scanner_.line()),
                                                with::index<"facet">(soup_.triangles.size() + 1),
                                                with::cause<"wanted">(std::move(expected))));
    return badInput(message<"stl-ascii-unexpected">(with::index<"line">(scanner_.line()),
                                                    with::quoted<"word">(excerpt(word)),
                                                    with::cause<"wanted">(std::move(expected))));
  }

  /// Returns the next word. A keyword may be written as two words: "end facet" is "endfacet".
  std::string_view nextWord() {
    const std::string_view word = scanner_.word();
    if (!equalsIgnoringCase(word, "end")) return word;
    const TextScanner before = scanner_;
    const std::string_view second = scanner_.wordOnLine();
    for (const std::string_view keyword : {"endsolid", "endfacet", "endloop"})
      if (equalsIgnoringCase(second, keyword.substr(3))) return keyword;
    scanner_ = before;
    return word;
  }

  Status expect(std::string_view keyword) {
    const std::string_view word = nextWord();
    if (equalsIgnoringCase(word, keyword)) return {};
    return unexpected(word, wantsKeyword(keyword));
  }

  Result<Vec3> readCorner() {
    QRELIEF_TRY(expect("vertex"));
    Vec3 p(0);
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = scanner_.word();
      const std::optional<double> value = parseNumber(word);
      if (!value && hasDecimalComma(word)) return decimalComma("STL", scanner_.line(), word);
      if (!value) return unexpected(word, message<"stl-wants-number">());
      p[axis] = *value;
    }
    if (!isFinite(p))
      return badInput(message<"stl-ascii-not-finite">(with::index<"line">(scanner_.line()),
                                                      with::index<"facet">(soup_.triangles.size() + 1),
                                                      with::term<"at">(coordinates(p))));
    return p;
  }

  Status readFacet() {
    if (soup_.triangles.size() == limits_.maxTriangles) return tooManyTriangles(limits_.maxTriangles);
    std::string_view word = scanner_.word();
    for (int i = 0; i < 4 && !equalsIgnoringCase(word, "outer"); ++i)
      word = scanner_.word();  // skip "normal x y z": it follows from the corners
    if (!equalsIgnoringCase(word, "outer")) return unexpected(word, wantsKeyword("outer loop"));
    QRELIEF_TRY(expect("loop"));
    std::array<Vec3, 3> corners;
    for (Vec3& corner : corners) {
      const Result<Vec3> p = readCorner();
      QRELIEF_TRY(p);
      corner = *p;
    }
    QRELIEF_TRY(expect("endloop"));
    QRELIEF_TRY(expect("endfacet"));
    addFacet(soup_, corners);
    return {};
  }

  TextScanner scanner_;
  const ReadLimits& limits_;
  PolygonSoup soup_;
  std::size_t unended_ = 0;  // solids that another solid follows before their "endsolid"
  std::size_t linesSkipped_ = 0;
  std::size_t firstLineSkipped_ = 0;
};

}  // namespace

bool looksLikeAsciiStl(std::span<const std::uint8_t> bytes) {
  TextScanner scanner(textOf(bytes));
  if (!equalsIgnoringCase(scanner.word(), "solid")) return false;
  skipName(scanner);
  for (std::size_t line = 0; line < kLinesLookedAt; ++line) {
    const std::string_view word = scanner.word();
    if (word.empty()) return line == 0;
    if (equalsIgnoringCase(word, "facet") || equalsIgnoringCase(word, "endsolid")) return true;
    if (equalsIgnoringCase(word, "end")) return equalsIgnoringCase(scanner.wordOnLine(), "solid");
    scanner.restOfLine();  // a colour, for example
  }
  return false;
}

bool isBinaryStl(std::span<const std::uint8_t> bytes) {
  return bytes.size() > kHeaderBytes && bytes.size() == kHeaderBytes + kFacetBytes * announcedFacets(bytes);
}

Result<PolygonSoup> readStl(std::span<const std::uint8_t> bytes, const ReadLimits& limits) {
  if (!isBinaryStl(bytes) && looksLikeAsciiStl(bytes)) return AsciiReader(textOf(bytes), limits).read();
  return readBinary(bytes, limits);
}

}  // namespace qrelief
