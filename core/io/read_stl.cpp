// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_stl.h"

#include <cmath>
#include <fmt/format.h>

#include "io/load_bytes.h"
#include "io/parse_number.h"
#include "io/polygon_list.h"
#include "io/text_scanner.h"

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

Status checkFinite(Vec3 p, std::size_t facet, const std::string& where) {
  if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) return {};
  return fail(
      ErrorKind::BadInput,
      fmt::format("Facet {} ({}) has a corner at ({}, {}, {}), which is not finite", facet, where, p.x, p.y, p.z),
      "Export the model again; something went wrong when it was made");
}

void addFacet(PolygonSoup& soup, const std::array<Vec3, 3>& corners) {
  const auto first = static_cast<std::uint32_t>(soup.positions.size());
  soup.positions.insert(soup.positions.end(), corners.begin(), corners.end());
  soup.triangles.push_back({first, first + 1, first + 2});
}

Status checkBinarySize(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHeaderBytes)
    return fail(
        ErrorKind::BadInput,
        fmt::format("This is no STL file: {} bytes are fewer than the {} of a binary STL's header, and it does not "
                    "begin with \"solid\"",
                    bytes.size(), kHeaderBytes),
        "Check that the file is complete and that its extension is right");
  const std::uint64_t count = announcedFacets(bytes);
  const std::uint64_t expected = kHeaderBytes + kFacetBytes * count;
  if (count == 0) return fail(ErrorKind::BadInput, "The binary STL file announces 0 facets", "Export the model again");
  if (bytes.size() < expected)
    return fail(
        ErrorKind::BadInput,
        fmt::format("The binary STL file is cut off or its facet count is wrong: it announces {} facets, which take "
                    "{} bytes, but has {} bytes, room for {} facets",
                    count, expected, bytes.size(), (bytes.size() - kHeaderBytes) / kFacetBytes),
        "Copy or download the file again, or export it again");
  return {};
}

Result<PolygonSoup> readBinary(std::span<const std::uint8_t> bytes, const ReadLimits& limits) {
  if (Status s = checkBinarySize(bytes); !s) return tl::unexpected(s.error());
  const auto count = static_cast<std::size_t>(announcedFacets(bytes));
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
      if (Status s = checkFinite(p, f + 1, fmt::format("of {}", count)); !s) return tl::unexpected(s.error());
    addFacet(soup, corners);
  }
  if (const std::size_t rest = bytes.size() - kHeaderBytes - kFacetBytes * count; rest > 0)
    soup.warnings.push_back(
        fmt::format("{} bytes after the last of the {} announced facets were passed over", rest, count));
  return soup;
}

class AsciiReader {
 public:
  AsciiReader(std::string_view text, const ReadLimits& limits) : scanner_(text), limits_(limits) {}

  Result<PolygonSoup> read() {
    soup_.format = "STL (ASCII)";
    bool insideSolid = false;
    for (std::string_view word = scanner_.word(); !word.empty(); word = scanner_.word()) {
      if (!insideSolid && equalsIgnoringCase(word, "solid")) {
        scanner_.restOfLine();
        insideSolid = true;
      } else if (insideSolid && equalsIgnoringCase(word, "endsolid")) {
        scanner_.restOfLine();
        insideSolid = false;
      } else if (insideSolid && equalsIgnoringCase(word, "facet")) {
        if (Status s = readFacet(); !s) return tl::unexpected(s.error());
      } else {
        return unexpected(word, insideSolid ? "\"facet\" or \"endsolid\"" : "\"solid\"");
      }
    }
    if (soup_.triangles.empty())
      return fail(ErrorKind::BadInput, "The ASCII STL file holds no facet", "Export the model again");
    if (insideSolid) soup_.warnings.push_back("The file ends without \"endsolid\"; it may be cut off");
    return std::move(soup_);
  }

 private:
  tl::unexpected<Error> unexpected(std::string_view word, std::string_view wanted) const {
    return fail(ErrorKind::BadInput,
                word.empty()
                    ? fmt::format("The ASCII STL file ends in line {}, inside facet {}, where {} should follow",
                                  scanner_.line(), soup_.triangles.size() + 1, wanted)
                    : fmt::format("Line {} of the ASCII STL file: {} where {} should stand", scanner_.line(),
                                  quoted(word), wanted),
                "The file is cut off or damaged; export it again");
  }

  Status expect(std::string_view keyword) {
    const std::string_view word = scanner_.word();
    if (equalsIgnoringCase(word, keyword)) return {};
    return unexpected(word, fmt::format("\"{}\"", keyword));
  }

  Result<Vec3> readCorner() {
    if (Status s = expect("vertex"); !s) return tl::unexpected(s.error());
    Vec3 p(0);
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = scanner_.word();
      const std::optional<double> value = parseNumber(word);
      if (!value) return unexpected(word, "a number");
      p[axis] = *value;
    }
    if (Status s = checkFinite(p, soup_.triangles.size() + 1, fmt::format("line {}", scanner_.line())); !s)
      return tl::unexpected(s.error());
    return p;
  }

  Status readFacet() {
    if (soup_.triangles.size() == limits_.maxTriangles) return tooManyTriangles(limits_.maxTriangles);
    std::string_view word = scanner_.word();
    for (int i = 0; i < 4 && !equalsIgnoringCase(word, "outer"); ++i)
      word = scanner_.word();  // "normal x y z" is passed over: it follows from the corners
    if (!equalsIgnoringCase(word, "outer")) return unexpected(word, "\"outer loop\"");
    if (Status s = expect("loop"); !s) return s;
    std::array<Vec3, 3> corners;
    for (Vec3& corner : corners) {
      const Result<Vec3> p = readCorner();
      if (!p) return tl::unexpected(p.error());
      corner = *p;
    }
    if (Status s = expect("endloop"); !s) return s;
    if (Status s = expect("endfacet"); !s) return s;
    addFacet(soup_, corners);
    return {};
  }

  TextScanner scanner_;
  const ReadLimits& limits_;
  PolygonSoup soup_;
};

}  // namespace

bool looksLikeAsciiStl(std::span<const std::uint8_t> bytes) {
  TextScanner scanner(textOf(bytes));
  if (!equalsIgnoringCase(scanner.word(), "solid")) return false;
  scanner.restOfLine();
  const std::string_view next = scanner.word();
  return next.empty() || equalsIgnoringCase(next, "facet") || equalsIgnoringCase(next, "endsolid");
}

bool isBinaryStl(std::span<const std::uint8_t> bytes) {
  return bytes.size() > kHeaderBytes && bytes.size() == kHeaderBytes + kFacetBytes * announcedFacets(bytes);
}

Result<PolygonSoup> readStl(std::span<const std::uint8_t> bytes, const ReadLimits& limits) {
  if (!isBinaryStl(bytes) && looksLikeAsciiStl(bytes)) return AsciiReader(textOf(bytes), limits).read();
  return readBinary(bytes, limits);
}

}  // namespace qrelief
