// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/polygon_list.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>

#include "base/utf8.h"
#include "io/parse_number.h"
#include "io/triangulate_polygon.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

Status checkPositions(const std::vector<Vec3>& positions, const std::string& format) {
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3& p = positions[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return badInput(
          message<"file-vertex-not-finite">(with::index<"vertex">(i + 1), with::count<"vertices">(positions.size()),
                                            with::term<"format">(format), with::term<"at">(coordinates(p))));
  }
  return {};
}

/// Number of faces with a certain fault, and the first of them.
struct Noted {
  std::size_t count = 0;
  std::size_t first = 0;  ///< in the file's order, from 1
  Vec3 at{0};             ///< its first corner

  void add(std::size_t face, Vec3 corner) {
    if (++count == 1) first = face, at = corner;
  }
};

/// @returns true if the polygon is simple
bool triangulateFace(const PolygonList& list, std::span<const std::uint32_t> face, PolygonSoup& soup) {
  std::vector<Vec3> corners;
  for (const std::uint32_t v : face) corners.push_back(list.positions[v]);
  const PolygonTriangles cut = triangulatePolygon(corners);
  for (const auto& [a, b, c] : cut.triangles) soup.triangles.push_back({face[a], face[b], face[c]});
  return cut.simple;
}

Colour meanColour(std::span<const Colour> colours, const Triangle& triangle) {
  Colour mean{};
  for (std::size_t k = 0; k < mean.size(); ++k) {
    int sum = 0;
    for (const std::uint32_t v : triangle) sum += colours[v][k];
    mean[k] = static_cast<std::uint8_t>((sum + 1) / 3);
  }
  return mean;
}

}  // namespace

tl::unexpected<Error> tooManyTriangles(std::size_t limit) {
  return badInput(message<"file-too-many-triangles">(with::count<"limit">(limit)));
}

Status PolygonList::reserve(std::uint64_t vertices, std::uint64_t faces) {
  if (faces > maxTriangles || vertices > 3 * std::uint64_t{maxTriangles}) return tooManyTriangles(maxTriangles);
  positions.reserve(static_cast<std::size_t>(vertices));
  sizes.reserve(static_cast<std::size_t>(faces));
  corners.reserve(static_cast<std::size_t>(3 * faces));
  return {};
}

Status PolygonList::add(std::span<const std::uint32_t> polygon) {
  if (polygon.size() > 2) triangles += polygon.size() - 2;
  if (triangles > maxTriangles) return tooManyTriangles(maxTriangles);
  corners.insert(corners.end(), polygon.begin(), polygon.end());
  sizes.push_back(static_cast<std::uint32_t>(polygon.size()));
  return {};
}

Result<PolygonSoup> triangulated(PolygonList&& list, std::string format) {
  assert(std::all_of(list.corners.begin(), list.corners.end(),
                     [&](std::uint32_t v) { return v < list.positions.size(); }));
  QRELIEF_TRY(checkPositions(list.positions, format));
  if (list.triangles == 0)
    return badInput(message<"file-no-face">(with::term<"format">(format), with::count<"count">(list.positions.size())));

  PolygonSoup soup;
  Noted tooSmall, notSimple;
  soup.triangles.reserve(list.triangles);
  const std::uint32_t* face = list.corners.data();
  std::size_t number = 0;
  for (const std::uint32_t size : list.sizes) {
    ++number;
    if (size == 3)
      soup.triangles.push_back({face[0], face[1], face[2]});
    else if (size < 3)
      tooSmall.add(number, Vec3(0));
    else if (!triangulateFace(list, {face, size}, soup))
      notSimple.add(number, list.positions[face[0]]);
    face += size;
  }
  if (tooSmall.count > 0)
    soup.warnings.push_back(
        message<"faces-passed-over">(with::count<"count">(tooSmall.count), with::index<"face">(tooSmall.first)));
  if (notSimple.count > 0)
    soup.warnings.push_back(message<"polygons-not-simple">(
        with::count<"count">(notSimple.count), with::index<"face">(notSimple.first), with::place<"at">(notSimple.at)));
  if (list.colours.size() == list.positions.size())
    for (const Triangle& triangle : soup.triangles) soup.colours.emplace_back(meanColour(list.colours, triangle));
  soup.positions = std::move(list.positions);
  soup.format = std::move(format);
  return soup;
}

bool hasDecimalComma(std::string_view word) {
  std::string pointed(word);
  std::replace(pointed.begin(), pointed.end(), ',', '.');
  return pointed != word && parseNumber(pointed);
}

tl::unexpected<Error> decimalComma(std::string_view format, std::size_t line, std::string_view word) {
  return badInput(message<"file-decimal-comma">(with::index<"line">(line), with::term<"format">(format),
                                                with::quoted<"word">(excerpt(word))));
}

Message notANumber(std::string_view word) {
  if (word.empty()) return message<"number-missing">();
  if (hasDecimalComma(word)) return message<"number-decimal-comma">(with::quoted<"word">(excerpt(word)));
  return message<"number-malformed">(with::quoted<"word">(excerpt(word)));
}

Message notFinite(std::string_view word) { return message<"number-not-finite">(with::quoted<"word">(excerpt(word))); }

Message notAVertex(std::string_view word) { return message<"index-malformed">(with::quoted<"word">(excerpt(word))); }

Message noSuchVertex(std::int64_t index, std::size_t vertices) {
  return message<"face-vertex-missing">(with::index<"vertex">(index), with::count<"count">(vertices));
}

std::string coordinates(Vec3 p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z); }

std::string excerpt(std::string_view word, std::size_t longest) {
  std::string text;
  for (std::size_t shown = 0; !word.empty() && shown < longest; ++shown) {
    const std::size_t length = utf8SequenceLength(word);
    const bool isControl = length == 1 ? word[0] < ' ' || word[0] == 127 : word.starts_with("\xC2") && word[1] < '\xA0';
    text += length == 0 || isControl ? "?" : word.substr(0, length);
    word.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return text + (word.empty() ? "" : "...");
}

}  // namespace qrelief
