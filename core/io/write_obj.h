// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/write_model.h"

namespace qrelief {

/// Writes Wavefront OBJ: `o`, `v` and `f` lines. Numbers are the shortest that give the same 32-bit floats.
std::vector<std::uint8_t> writeObj(std::span<const ModelObject> objects, const WriteOptions& options);

}  // namespace qrelief
