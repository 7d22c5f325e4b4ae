// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace qrelief {

using Rgb8 = std::array<std::uint8_t, 3>;

/// Colours for numbers, distinguishable with red-green colour blindness. The first three grow lighter from one end to
/// the other; BlueRed is palest in the middle, for values on both sides of zero.
enum class ColourScale : std::uint8_t { Viridis, Cividis, Grey, BlueRed };
inline constexpr std::array<const char*, 4> kColourScaleNames = {"viridis", "cividis", "grey", "blue to red"};

/// Returns the colour at a share of the scale.
/// @param share  0 … 1 from one end of the scale to the other; outside, the colour of that end
Rgb8 colourAt(ColourScale scale, double share);

}  // namespace qrelief
