// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/read_model.h"

namespace qrelief {

/// Reads PLY 1.0 as text, binary little endian or binary big endian: `x`, `y`, `z` of element "vertex" and the list
/// "vertex_indices" or "vertex_index" of element "face". Skips everything else.
/// @returns BadInput naming header line, element and its number
Result<PolygonSoup> readPly(std::span<const std::uint8_t> bytes, const ReadLimits& limits);

}  // namespace qrelief
