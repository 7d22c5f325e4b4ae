// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "gl/objects.h"
#include "inspector/value_map.h"
#include "viewer/colour_scale.h"

namespace qrelief {

/// How numbers become colours.
struct MapColours {
  ColourScale scale = ColourScale::Viridis;
  ValueRange range;
  bool showsDirections = false;  ///< of a map that has them: right, up, towards the reader as red, green, blue
};

/// Four bytes a value, row 0 at the top; what is not a number is clear.
std::vector<std::uint8_t> colouredRgba(const ValueMap& map, const MapColours& colours);

/// The same as a texture, RGBA8, row 0 at the top.
gl::Texture mapPicture(const ValueMap& map, const MapColours& colours);

}  // namespace qrelief
