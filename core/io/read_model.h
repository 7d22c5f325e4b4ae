// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/result.h"
#include "mesh/polygon_soup.h"

namespace qrelief {

struct ReadLimits {
  std::size_t maxBytes = std::size_t{1} << 30;
  std::size_t maxTriangles = 20'000'000;
  std::uint64_t maxExpandedBytes = std::uint64_t{1} << 31;  ///< of what a 3MF file's archive is unpacked to
};

/// Reads OBJ (tinyobjloader), STL (binary and ASCII), PLY (ASCII, both endians), OFF (ASCII) or 3MF.
///
/// The format follows from the name's extension; where the content plainly is another one, that one is read and a
/// warning says so, or it is refused. Text has to be UTF-8 or ASCII; UTF-16 is refused by name. Nothing is allocated by
/// a count that the file's size does not bear out. Polygons are triangulated in their own plane (concave ones by ear
/// clipping).
/// @param bytes     the whole file
/// @param fileName  only its extension is used
/// @returns file units (and what they are, where the file says so); BadInput naming line, facet or byte for anything
/// malformed
Result<PolygonSoup> readModel(std::span<const std::uint8_t> bytes, std::string_view fileName,
                              const ReadLimits& limits = {});

}  // namespace qrelief
