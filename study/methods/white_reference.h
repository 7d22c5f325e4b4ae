// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

namespace qrelief::study {

/// Returns white as in Peng 2019 and Peng 2020: the mean of the brightest tenth of the light submodules' greys.
/// @param greys  not empty
inline double whiteReference(std::vector<double> greys) {
  const std::size_t count = std::max<std::size_t>(1, greys.size() / 10);
  std::partial_sort(greys.begin(), greys.begin() + static_cast<std::ptrdiff_t>(count), greys.end(), std::greater<>());
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += greys[i];
  return sum / static_cast<double>(count);
}

}  // namespace qrelief::study
