// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/read_model.h"

namespace qrelief {

/// OFF as text, with its three-dimensional variants (COFF, NOFF, STOFF and their mixtures): colours, normals and
/// texture coordinates are passed over; a vertex or face may be followed by more numbers on its line.
/// @returns BadInput naming the line
Result<PolygonSoup> readOff(std::span<const std::uint8_t> bytes, const ReadLimits& limits);

/// The first word of an OFF file: [ST][C][N][4][n]OFF.
bool isOffKeyword(std::string_view word);

}  // namespace qrelief
