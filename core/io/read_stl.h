// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/read_model.h"

namespace qrelief {

/// Returns true if the size is exactly right for a binary STL with the declared number of facets. Such a file is
/// binary STL, whatever its header says.
bool isBinaryStl(std::span<const std::uint8_t> bytes);

/// Returns true if the file begins with "solid" and a name, and a later line has "facet" or "endsolid".
bool looksLikeAsciiStl(std::span<const std::uint8_t> bytes);

/// Reads binary and ASCII STL: three new positions per facet, nothing welded. Skips normals, colours and names.
///
/// The file is binary if its size is 84 + 50·facets, ASCII if it begins with "solid" and "facet" follows, otherwise
/// binary. ASCII files may hold several solids one after the other; words after "endfacet" are skipped with a warning.
/// @returns BadInput naming sizes, facet or line
Result<PolygonSoup> readStl(std::span<const std::uint8_t> bytes, const ReadLimits& limits);

}  // namespace qrelief
