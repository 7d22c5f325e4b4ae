// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/write_model.h"

namespace qrelief {

/// Calls writeModel() and reads the bytes back. Every triangle must come out in its place with its corners bit for bit;
/// in an object with an offset, the last digit may differ. After welding equal positions, as every parser of solids
/// does, the triangles are the solid that was written.
///
/// Cost: writing the file and reading it once.
/// @returns BadUsage as writeModel(); Internal if the file differs from the input
Result<std::vector<std::uint8_t>> writeChecked(std::span<const ModelObject> objects, ModelFormat format,
                                               const WriteOptions& options = {});

}  // namespace qrelief
