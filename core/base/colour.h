// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace qrelief {

/// Red, green, blue; sRGB.
using Colour = std::array<std::uint8_t, 3>;

}  // namespace qrelief
