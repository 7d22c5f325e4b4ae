// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace qrelief {

/// Mirrors the digits of `index` in `base` at the point [van der Corput 1935]: 1, 2, 3, 4 … in base 2 give 1/2, 1/4,
/// 3/4, 1/8 …; 0 gives 0. Cost: one division per digit.
/// @param base  ≥ 2
/// @returns a value in [0, 1)
inline double radicalInverse(std::uint32_t index, std::uint32_t base) {
  assert(base >= 2);
  // Numerator and denominator are whole numbers below 2^53 for every index in bases 2 and 3: one rounding in all.
  double reversed = 0;
  double denominator = 1;
  for (; index > 0; index /= base) {
    reversed = reversed * base + index % base;
    denominator *= base;
  }
  return reversed / denominator;
}

/// Returns point `index` of the Halton sequence in bases 2 and 3 [Halton 1960], in [0, 1)². Start at 1: point 0 is the
/// corner.
inline std::array<double, 2> halton23(std::uint32_t index) {
  return {radicalInverse(index, 2), radicalInverse(index, 3)};
}

/// Returns the fractional part of a number, in [0, 1). Brings a shifted point back into the unit square.
inline double wrapped(double x) { return x - std::floor(x); }

}  // namespace qrelief
