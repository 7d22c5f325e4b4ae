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
  std::uint64_t maxExpandedBytes = std::uint64_t{1} << 31;  ///< total unpacked size of a 3MF archive
};

/// Reads OBJ (tinyobjloader), STL (binary and ASCII), PLY (ASCII, both endians), OFF (ASCII) or 3MF, also as the only
/// model of a ZIP archive.
///
/// The extension of the name gives the format. If the content is clearly another format, that one is read with a
/// warning, or the file is refused, by name if possible (io/sniff_format.h). Text must be UTF-8 or ASCII; UTF-16 is
/// refused by name. Nothing is allocated for a count that exceeds what the file's size allows. Polygons are
/// triangulated in their own plane (concave ones by ear clipping).
/// @param bytes     the whole file
/// @param fileName  only its extension is used
/// @returns positions in file units (and the unit, where the file states it); BadInput naming line, facet or byte for
///          anything malformed
Result<PolygonSoup> readModel(std::span<const std::uint8_t> bytes, std::string_view fileName,
                              const ReadLimits& limits = {});

}  // namespace qrelief
