// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "math/vec.h"
#include "verification/symbol_reader.h"

namespace qrelief {

/// One of the pictures from the front that a code must read in.
struct FrontalView {
  double pixelsPerModule = 8;
  Vec2 phase{0};              ///< of the pixel grid, in pixels
  double blurModules = 0.07;  ///< standard deviation, in modules
};

/// They differ in scale, pixel phase and blur: that a decoder succeeds with one of them says little.
inline constexpr std::array<FrontalView, 6> kFrontalViews = {{{8, Vec2(0, 0), 0.07},
                                                              {8, Vec2(0.5, 0.3), 0.15},
                                                              {6.5, Vec2(0, 0), 0.07},
                                                              {6.5, Vec2(0.5, 0.3), 0.15},
                                                              {5, Vec2(0, 0), 0.07},
                                                              {5, Vec2(0.5, 0.3), 0.15}}};

/// Tries of decoders, and how many of them gave the wanted text, not mirrored.
struct ReadingCount {
  int tries = 0, reads = 0;

  /// A code reads if at least two in five tries succeed. A decoder that gets so many of them through has a code before
  /// it that most other decoders get, too.
  static int needed(int tries) { return (2 * tries + 4) / 5; }
  int needed() const { return needed(tries); }
  bool enough() const { return tries > 0 && reads >= needed(); }

  bool operator==(const ReadingCount&) const = default;
};

/// What is given to decoders: every view of kFrontalViews in every variant of verification/reading_variants.h. A view
/// finer than the luminance takes the luminance as it is.
/// @param luminance        linear, width² values, row 0 at the bottom
/// @param pixelsPerModule  of the luminance, > 0
std::vector<GreyImage> frontalPictures(const std::vector<float>& luminance, int width, double pixelsPerModule);

}  // namespace qrelief
