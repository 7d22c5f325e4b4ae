// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/write_model.h"

namespace qrelief {

/// Writes PLY 1.0, binary little endian, with positions as 32-bit floats bit for bit.
std::vector<std::uint8_t> writePly(std::span<const ModelObject> objects, const WriteOptions& options);

}  // namespace qrelief
