// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "carving/depth_field.h"
#include "light/directional_light.h"
#include "qr/module_pattern.h"
#include "qr/symbol.h"

namespace qrelief::study {

/// What a method makes of a spot.
struct CarvedCode {
  Symbol symbol;  ///< as it is carved: some methods make modules light
  SubmoduleMask mask;
  DepthField depths;
  /// Share of the unoccluded light that the method itself believes to reach each submodule of the mask's carved ones,
  /// in their order; empty if it does not say.
  std::vector<double> ownEstimate;
  std::optional<DirectionalLight> readUnder = {};  ///< the one lamp that it is made for; none: the sky
  int passes = 0;
  std::size_t limited = 0;  ///< submodules that a wall kept from being dark enough
  double milliseconds = 0;  ///< to find the depths
};

/// Indices of the carved submodules, row-major.
inline std::vector<std::uint32_t> carvedOf(const SubmoduleMask& mask) {
  std::vector<std::uint32_t> carved;
  for (std::uint32_t i = 0; i < mask.carved.size(); ++i)
    if (mask.carved[i]) carved.push_back(i);
  return carved;
}

}  // namespace qrelief::study
