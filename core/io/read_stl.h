// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/read_model.h"

namespace qrelief {

/// True if the size is exactly what a binary STL of the announced number of facets has: then it is one, whatever its
/// header says.
bool isBinaryStl(std::span<const std::uint8_t> bytes);

/// True if it begins with "solid", a name, and "facet" or "endsolid" in a later line.
bool looksLikeAsciiStl(std::span<const std::uint8_t> bytes);

/// Binary and ASCII STL: three new positions a facet, nothing welded; normals, colours and names are passed over.
///
/// It is binary if the size is 84 + 50·facets, ASCII if it begins with "solid" and "facet" follows, else binary.
/// ASCII files may hold several solids one after the other; words behind "endfacet" are passed over with a warning.
/// @returns BadInput naming sizes, facet or line
Result<PolygonSoup> readStl(std::span<const std::uint8_t> bytes, const ReadLimits& limits);

}  // namespace qrelief
