// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/read_model.h"

namespace qrelief {

/// Reads OFF as text, with its three-dimensional variants (COFF, NOFF, STOFF and their mixtures). Skips colours,
/// normals, texture coordinates and further numbers on the line of a vertex or face. In a plain OFF that this does not
/// suit, vertices and faces need not end with a line.
///
/// Cost: linear; reads such a file up to five times.
/// @returns BadInput naming the line
Result<PolygonSoup> readOff(std::span<const std::uint8_t> bytes, const ReadLimits& limits);

/// Returns true for the first word of an OFF file: [ST][C][N][4][n]OFF, with or without a number after it.
bool isOffKeyword(std::string_view word);

}  // namespace qrelief
