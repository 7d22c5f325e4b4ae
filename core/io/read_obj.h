// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/read_model.h"

namespace qrelief {

/// The `v` and `f` lines of a Wavefront OBJ, by tinyobjloader; all others (normals, materials, groups, curves) are
/// passed over. Relative indices, polygons of any size, continued lines ("\") and every kind of line end are fine.
///
/// tinyobjloader reads 0 where a number is missing or malformed and keeps indices that point nowhere, so each line is
/// looked through before it gets it.
/// @returns BadInput naming the line
Result<PolygonSoup> readObj(std::span<const std::uint8_t> bytes, const ReadLimits& limits);

}  // namespace qrelief
