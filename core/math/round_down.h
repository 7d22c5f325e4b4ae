// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace qrelief {

/// Rounds a length down to the three digits that messages show, so that a bound still holds as written.
inline double downToThreeDigits(double mm) {
  if (!(mm > 0)) return mm;
  const double step = std::min(1.0, std::pow(10, std::floor(std::log10(mm)) - 2));
  return std::floor(mm / step) * step;
}

}  // namespace qrelief
