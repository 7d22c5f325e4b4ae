// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "verification/reader_view.h"

namespace qrelief {

/// Encodes an 8-bit grey PNG (libpng).
Result<std::vector<std::uint8_t>> encodePng(const GreyImage& image);

}  // namespace qrelief
