// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/result.h"
#include "gl/objects.h"

namespace qrelief {

/// How a map is to be read.
struct MapReading {
  bool isNormal = false;    ///< first three components are a unit vector; else one component is a value
  int component = 0;        ///< of the value, 0 … 3
  bool hasSurface = false;  ///< texels whose first three components are zero lie outside the model
  bool topFirst = false;    ///< row 0 of the map is its upper one (as of texels uploaded from rows); else the lower one
};

/// A float map as a picture in colours, and its values: a copy, so that the map may go.
class MapPicture {
 public:
  /// Reads the map back, finds the range of its values, and renders it.
  /// @param sizePx  edge of the picture
  static Result<MapPicture> create(const gl::Texture& map, const MapReading& reading, int sizePx);

  const gl::Texture& picture() const { return picture_; }  ///< RGBA8, row 0 at the bottom
  float lowest() const { return lowest_; }
  float highest() const { return highest_; }
  /// The texel at a place of the picture, (0, 0) = upper left, (1, 1) = lower right; four floats, or null outside.
  const float* texelAt(double across, double down) const;

 private:
  MapReading reading_;
  int columns_ = 0, rows_ = 0;
  std::vector<float> texels_;  // RGBA
  float lowest_ = 0, highest_ = 1;
  gl::Texture picture_;
};

}  // namespace qrelief
