// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/write_model.h"

namespace qrelief {

/// writeModel(), and the very bytes read back: every triangle must come out in its place, its corners bit for bit;
/// those of an object that is moved, but for the last digit.
/// Welded by equal positions, as every reader of a solid does, they then are the same solid as what was written.
///
/// Cost: that of writing and of reading.
/// @returns BadUsage as writeModel(); Internal if the file says anything else than it should
Result<std::vector<std::uint8_t>> writeChecked(std::span<const ModelObject> objects, ModelFormat format,
                                               const WriteOptions& options = {});

}  // namespace qrelief
