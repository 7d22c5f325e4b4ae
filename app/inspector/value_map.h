// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "gl/objects.h"
#include "math/vec.h"
#include "viewer/colour_scale.h"

namespace qrelief {

/// A picture of numbers over symbol and quiet zone, as seen from the viewer's eye: row 0 at the top.
struct ValueMap {
  static constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

  int columns = 0, rows = 0;
  std::vector<float> values;  ///< row-major; kNothing where there is no value
  std::vector<Vec3f>
      directions;  ///< unit vectors (right, up, to the viewer); each value is its vector's angle; may be empty

  /// Returns the index of the value at a position, (0, 0) = upper left, (1, 1) = lower right; none outside.
  std::optional<std::size_t> indexAt(Vec2 place) const;
};

struct ValueRange {
  float lowest = 0, highest = 1;
  bool operator==(const ValueRange&) const = default;
};

/// Returns the range of the values that are numbers, cut by a share at either end; none if there are none.
/// @param cutShare  0 … 0.5: keeps a few far outliers from taking up all colours
std::optional<ValueRange> rangeOf(std::span<const float> values, double cutShare = 0);

/// Counts the values in each of equal parts of a range. Values outside it count towards the nearest part; NaN is not
/// counted.
std::vector<int> histogramOf(std::span<const float> values, ValueRange range, int parts);

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
