// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/write_model.h"

namespace qrelief {

/// Writes Wavefront OBJ: `o`, `v` and `f` lines. Numbers are the shortest that give the same 32-bit floats. With
/// WriteOptions::materialFile, bodies and painted facets of colour n have the material `colour-n` of that file.
std::vector<std::uint8_t> writeObj(std::span<const ModelObject> objects, const WriteOptions& options);

/// Writes the file with the materials: a diffuse colour for each colour of the objects.
std::vector<std::uint8_t> writeMaterials(std::span<const ModelObject> objects);

}  // namespace qrelief
