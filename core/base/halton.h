// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace qrelief {

/// Radical inverse of `index` in `base` (a prime): its digits mirrored at the point, in [0, 1). Bases 2 and 3 together
/// give the Halton sequence in the plane [Halton 1960]; start at index 1.
inline double radicalInverse(unsigned base, unsigned index) {
  double result = 0;
  double place = 1.0 / base;
  for (; index > 0; index /= base, place /= base) result += (index % base) * place;
  return result;
}

}  // namespace qrelief
