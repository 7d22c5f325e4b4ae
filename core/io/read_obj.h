// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/read_model.h"

namespace qrelief {

/// Reads the `v` and `f` lines of a Wavefront OBJ by tinyobjloader; skips all others (normals, materials, groups,
/// curves). Accepts relative indices, polygons of any size, continued lines ("\") and every kind of line end.
///
/// tinyobjloader reads 0 where a number is missing or malformed and keeps invalid indices, so each line is checked
/// before tinyobjloader gets it.
/// @returns BadInput naming the line
Result<PolygonSoup> readObj(std::span<const std::uint8_t> bytes, const ReadLimits& limits);

}  // namespace qrelief
