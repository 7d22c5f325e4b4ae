// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace qrelief {

using Rgb8 = std::array<std::uint8_t, 3>;

/// Colours for numbers that people who confuse red and green can tell apart. The first three grow lighter from one end
/// to the other; BlueRed is palest in the middle, for values on both sides of zero.
enum class ColourScale : std::uint8_t { Viridis, Cividis, Grey, BlueRed };
inline constexpr std::array<const char*, 4> kColourScaleNames = {"viridis", "cividis", "grey", "blue to red"};

/// @param share  0 … 1 from one end of the scale to the other; beyond, the end's colour
Rgb8 colourAt(ColourScale scale, double share);

}  // namespace qrelief
