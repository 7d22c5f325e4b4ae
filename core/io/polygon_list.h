// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "mesh/polygon_soup.h"

namespace qrelief {

/// The positions and polygons that a parser collects; polygons have any size and keep the file's order.
struct PolygonList {
  std::vector<Vec3> positions;
  std::vector<Colour> colours;         ///< of the positions; used only if every position has one
  std::vector<std::uint32_t> corners;  ///< vertex indices of all polygons, one after the other
  std::vector<std::uint32_t> sizes;    ///< number of corners of each polygon
  std::size_t maxTriangles = 0;        ///< limit that add() enforces
  std::size_t triangles = 0;           ///< number of triangles that the polygons will give

  /// Reserves memory. Refuses more faces than the triangle limit, and more vertices than that many triangles can use.
  Status reserve(std::uint64_t vertices, std::uint64_t faces);
  Status add(std::span<const std::uint32_t> polygon);
};

/// Triangulates all polygons. Skips polygons of fewer than three corners and cuts up a self-crossing polygon as well as
/// possible, both with a warning.
/// @param list    with valid indices only: parsers refuse the first invalid one and name its line
/// @param format  goes into the soup and into messages
/// @returns BadInput if a position is not finite or there is no polygon at all
Result<PolygonSoup> triangulated(PolygonList&& list, std::string format);

/// Returns the error for a file with more than `limit` triangles.
tl::unexpected<Error> tooManyTriangles(std::size_t limit);

/// Returns true for a number with a comma for its point, such as "12,3".
bool hasDecimalComma(std::string_view word);

/// Returns the error for such a number.
tl::unexpected<Error> decimalComma(std::string_view format, std::size_t line, std::string_view word);

/// Returns the message for a word that should have been a number, such as "12,3". An empty word means that the
/// number is missing.
Message notANumber(std::string_view word);

/// Returns the message for a coordinate or factor that is not finite, such as "inf".
Message notFinite(std::string_view word);

/// Returns the message for a word that should have been a vertex index.
Message notAVertex(std::string_view word);

/// Returns the message for an index, counted from 0, that is not below `vertices`.
Message noSuchVertex(std::int64_t index, std::size_t vertices);

/// Formats a point that is not finite as text, because JSON messages cannot hold such numbers.
std::string coordinates(Vec3 p);

/// Shortens a word to fit into a message and replaces control characters and bytes that are not UTF-8.
/// @param longest  in characters
std::string excerpt(std::string_view word, std::size_t longest = 40);

}  // namespace qrelief
