// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/grid.h"
#include "math/vec.h"
#include "qr/symbol.h"

namespace qrelief {

/// Symbol contrasts of ISO/IEC 15415, as differences of reflectance: below the first the code is graded F, below the
/// second D or worse.
inline constexpr double kLeastInkContrast = 0.2, kGoodInkContrast = 0.4;

/// Diffuse reflectances of the two materials of a code in colour, 0 < r ≤ 1. The defaults are black on white: a black
/// plastic reflects little more than the 4 % of its surface (Fresnel, refractive index 1.5), and a plastic filled with
/// titanium white reflects about 85 %.
struct Ink {
  double dark = 0.05;   ///< of the dark modules
  double light = 0.85;  ///< of the body, with light modules and quiet zone

  bool isInverted() const { return dark > light; }  ///< true: the dark modules are lighter than the body
  double contrast() const { return isInverted() ? dark - light : light - dark; }

  bool operator==(const Ink&) const = default;
};

/// The two materials of a code, as a map on the QR plane.
class InkMap {
 public:
  /// Makes the map of a code as designed: every dark module is a whole square.
  /// @param symbolMm  edge without quiet zone, > 0
  InkMap(const Symbol& symbol, double symbolMm, Ink ink);

  /// @param darkShares  of the area of each pixel of a square picture centred on the code, 0 … 1
  /// @param pixelMm     > 0
  InkMap(BottomUp<float> darkShares, double pixelMm, Ink ink);

  /// Returns the reflectance at a point of the QR plane, as a multiple of the body's.
  float factor(Vec2 onPlane) const;

  /// Multiplies the luminance of a square picture centred on the code by the reflectance at the middle of each pixel.
  /// Pixels that lie within a pixel of the map are exact.
  /// @param pixelMm  on the QR plane, > 0
  void apply(BottomUp<float>& luminance, double pixelMm) const;

 private:
  BottomUp<float> darkShares_;
  double pixelMm_ = 0;
  float darkFactor_ = 1;
};

/// Returns luminances as if the darker material of an inverted code were its dark modules: mirrored between the two
/// reflectances. Grades and thresholds expect that order. Other codes stay unchanged.
/// @param luminance  1 = the body's material under the open sky
Grid<double> withoutInversion(Grid<double> luminance, const Ink& ink);

}  // namespace qrelief
