// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/grid.h"
#include "math/vec.h"
#include "verification/decoder.h"

namespace qrelief {

/// Settings of one frontal picture in the reading test.
struct FrontalView {
  double pixelsPerModule = 8;
  Vec2 phase{0};              ///< offset of the pixel grid, in pixels
  double blurModules = 0.07;  ///< standard deviation, in modules
};

/// Views that differ in scale, pixel phase and blur, because success with a single view proves little.
inline constexpr std::array<FrontalView, 6> kFrontalViews = {{{8, Vec2(0, 0), 0.07},
                                                              {8, Vec2(0.5, 0.3), 0.15},
                                                              {6.5, Vec2(0, 0), 0.07},
                                                              {6.5, Vec2(0.5, 0.3), 0.15},
                                                              {5, Vec2(0, 0), 0.07},
                                                              {5, Vec2(0.5, 0.3), 0.15}}};

/// Number of decoding tries, and of tries that gave the wanted text, not mirrored.
struct ReadingCount {
  int tries = 0, reads = 0;

  /// Returns the number of tries that must succeed: at least two in five. When one decoder succeeds this often, most
  /// other decoders read the code, too.
  static int needed(int tries) { return (2 * tries + 4) / 5; }
  int needed() const { return needed(tries); }
  bool enough() const { return tries > 0 && reads >= needed(); }

  bool operator==(const ReadingCount&) const = default;
};

/// Returns the pictures to decode: every view of kFrontalViews in every variant of verification/reading_variants.h. A
/// view finer than the luminance uses the luminance as it is.
/// @param luminance        linear, square
/// @param pixelsPerModule  resolution of the luminance, > 0
std::vector<GreyImage> frontalPictures(const BottomUp<float>& luminance, double pixelsPerModule);

}  // namespace qrelief
