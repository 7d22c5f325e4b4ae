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

/// What a reader collects: positions, and polygons of any size in the file's order.
struct PolygonList {
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> corners;  ///< of all polygons, one after the other
  std::vector<std::uint32_t> sizes;    ///< corners of each polygon
  std::size_t maxTriangles = 0;        ///< add() refuses more
  std::size_t triangles = 0;           ///< that the polygons will give

  /// Makes room; refuses more faces than triangles are accepted, and more vertices than those could use.
  Status reserve(std::uint64_t vertices, std::uint64_t faces);
  Status add(std::span<const std::uint32_t> polygon);
};

/// Triangles of all polygons; a polygon of fewer than three corners is passed over with a warning, one that crosses
/// itself is cut up as well as it can be, with a warning.
/// @param list    every index has its vertex: readers refuse the first that has none where it stands
/// @param format  goes into the soup and into messages
/// @returns BadInput where a position is not finite, or there is no polygon at all
Result<PolygonSoup> triangulated(PolygonList&& list, std::string format);

/// More triangles than `limit`.
tl::unexpected<Error> tooManyTriangles(std::size_t limit);

/// "12,3" is a comma of some locale: what to say about a word that should have been a number; empty: it is missing.
Message notANumber(std::string_view word);

/// What to say of a coordinate or factor such as "inf".
Message notFinite(std::string_view word);

/// What to say of a word that should have been a vertex's index.
Message notAVertex(std::string_view word);

/// What to say of an index, counted from 0, that is not among `vertices`.
Message noSuchVertex(std::int64_t index, std::size_t vertices);

/// A point that is not finite, as text: messages in JSON know no such numbers.
std::string coordinates(Vec3 p);

/// The word without control characters and cut to a length that fits into a message.
std::string excerpt(std::string_view word, std::size_t longest = 40);

}  // namespace qrelief
