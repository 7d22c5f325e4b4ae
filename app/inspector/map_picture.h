// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "gl/objects.h"
#include "inspector/value_map.h"
#include "viewer/colour_scale.h"

namespace qrelief {

/// The mapping from numbers to colours.
struct MapColours {
  ColourScale scale = ColourScale::Viridis;
  ValueRange range;
  bool showsDirections = false;  ///< if the map has directions: right, up, towards the viewer as red, green, blue
};

/// Returns four bytes per value, row 0 at the top; transparent for NaN.
std::vector<std::uint8_t> colouredRgba(const ValueMap& map, const MapColours& colours);

/// Returns the same picture as a texture, RGBA8, row 0 at the top.
gl::Texture mapPicture(const ValueMap& map, const MapColours& colours);

}  // namespace qrelief
