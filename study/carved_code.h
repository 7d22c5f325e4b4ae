// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "depth/depth_field.h"
#include "light/directional_light.h"
#include "qr/module_pattern.h"
#include "qr/symbol.h"

namespace qrelief::study {

/// Result of a method at a spot.
struct CarvedCode {
  Symbol symbol;  ///< as carved: some methods make modules light
  SubmoduleMask mask;
  DepthField depths;
  /// Share of the unoccluded light that reaches each carved submodule of the mask by the method's own estimate, in
  /// their order; empty if the method has none.
  std::vector<double> ownEstimate;
  std::optional<DirectionalLight> readUnder = {};  ///< the one lamp that the code is carved for; none: the sky
  int passes = 0;
  std::size_t limited = 0;  ///< submodules that could not get dark enough because of a wall
  double milliseconds = 0;  ///< for the depth search
};

/// Returns the indices of the carved submodules, row-major.
inline std::vector<std::uint32_t> carvedOf(const SubmoduleMask& mask) {
  std::vector<std::uint32_t> carved;
  for (std::uint32_t i = 0; i < mask.size(); ++i)
    if (mask[i]) carved.push_back(i);
  return carved;
}

}  // namespace qrelief::study
